import { render } from "preact";

render(<main><h1>page</h1></main>, document.getElementById("app")!);
