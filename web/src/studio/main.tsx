/** The studio: `#/` creates tables, `#/job/ID` follows one, `#/scene/ID` edits, `#/compare/ID/ID` compares. */
import { render } from "preact";
import { followAddress, route, skip, useTitle } from "../ui/routing";
import "../ui/styles.css";
import "./studio.css";
import { ComparePage } from "./compare";
import { EditPage } from "./edit";
import { JobPage } from "./job";
import { JobsPanel } from "./jobs";
import { MakeForm } from "./make";
import { ScenesPanel } from "./scenes";
import { connect, connected, message, studio, type Message } from "./store";

function App() {
  return (
    <>
      <a class="skip" href="#main" onClick={skip}>
        Skip to content
      </a>
      <header class="bar">
        <a href="#/" class="brand">
          TabletopGen studio
        </a>
        <nav class="row" aria-label="Pages">
          <a href="#/">Make</a>
          <a href="#/scenes">Scenes</a>
        </nav>
        <p class="small quiet end">{studio.value && `version ${studio.value.version}`}</p>
      </header>
      <Messages />
      <main id="main" class="page">
        <Routed />
      </main>
    </>
  );
}

function Messages() {
  return (
    <div aria-live="polite" class="messages">
      {!connected.value && <p class="message">The studio is not responding. Restart it and open the address that it prints; nothing is lost.</p>}
      {message.value && route.value && message.value.at === location.hash && (
        <p class={message.value.bad ? "message" : "message fine"} role={message.value.bad ? "alert" : undefined}>
          {message.value.text} <Remedy remedy={message.value.remedy} />
          <button class="slim" onClick={() => (message.value = null)}>
            Close
          </button>
        </p>
      )}
    </div>
  );
}

function Remedy({ remedy }: { remedy: Message["remedy"] }) {
  if (!remedy) return null;
  const run = (): void => {
    message.value = null;
    remedy.run();
  };
  return (
    <button class="slim" onClick={run}>
      {remedy.label}
    </button>
  );
}

function Routed() {
  const [kind, ...ids] = route.value;
  if (kind === "job" && ids[0]) return <JobPage key={ids[0]} id={ids[0]} />;
  if (kind === "scene" && ids[0]) return <EditPage id={ids[0]} />;
  if (kind === "compare" && ids.length > 1) return <ComparePage ids={ids.slice(0, 4)} />;
  if (kind === "scenes") return <ScenesPage />;
  return <MakePage />;
}

function ScenesPage() {
  useTitle("Scenes – TabletopGen studio");
  return <ScenesPanel all />;
}

function MakePage() {
  useTitle("TabletopGen studio");
  return (
    <>
      <h1>Make a table</h1>
      <div class="sides">
        <MakeForm />
        <JobsPanel />
      </div>
      <ScenesPanel />
    </>
  );
}

/** A picture dropped outside the drop area must not replace this page. */
for (const kind of ["dragover", "drop"]) addEventListener(kind, (event) => event.preventDefault());
followAddress();
void connect();
render(<App />, document.getElementById("app")!);
