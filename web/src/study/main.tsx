import { render } from "preact";

render(<main><h1>study</h1></main>, document.getElementById("app")!);
