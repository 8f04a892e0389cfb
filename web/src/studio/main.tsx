/** The studio: `#/` makes tables, `#/job/ID` follows one, `#/scene/ID` edits, `#/compare/ID/ID`. */
import { signal } from "@preact/signals";
import { render } from "preact";
import "../ui/styles.css";
import "./studio.css";
import { ComparePage } from "./compare";
import { EditPage } from "./edit";
import { JobPage } from "./job";
import { JobsPanel } from "./jobs";
import { MakeForm } from "./make";
import { ScenesPanel } from "./scenes";
import { connect, connected, message, studio, type Message } from "./store";

const route = signal(parts());

function parts(): string[] {
  try {
    return location.hash.replace(/^#\/?/, "").split("/").filter(Boolean).map(decodeURIComponent);
  } catch {
    return []; // a damaged address is the first page
  }
}

function App() {
  return (
    <>
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
      {!connected.value && <p class="message">The studio does not answer. Start it again; nothing is lost.</p>}
      {message.value && (
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
  if (kind === "scenes") return <ScenesPanel all />;
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

addEventListener("hashchange", () => {
  route.value = parts();
  scrollTo(0, 0);
});
void connect();
render(<App />, document.getElementById("app")!);
