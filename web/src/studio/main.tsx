import { render } from "preact";

render(<main><h1>studio</h1></main>, document.getElementById("app")!);
