/** A scene of the gallery on its own page, alone or side by side with others. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Gallery, SceneRow } from "../data";
import type { Engine } from "../viewer/engine";
import { Viewer } from "../viewer/viewer";
import { addressOf, useTitle } from "../ui/routing";
import { Facts } from "./facts";

const folder = (row: SceneRow): string => `scenes/${encodeURIComponent(row.id)}/`;

export function ScenePage({ gallery, row }: { gallery: Gallery; row: SceneRow }) {
  const engine = useSignal<Engine | null>(null);
  const shown = gallery.scenes.filter((each) => !each.error);
  const before = shown[shown.indexOf(row) - 1];
  const after = shown[shown.indexOf(row) + 1];
  useTitle(`${row.name} – ${gallery.title}`);
  return (
    <>
      <header class="bar">
        <a href="#/">{gallery.title}</a>
        <h1>{row.name}</h1>
        <nav class="row end" aria-label="Other tables">
          {before && <a href={addressOf("scene", before.id)}>Previous</a>}
          {after && <a href={addressOf("scene", after.id)}>Next</a>}
          <Beside gallery={gallery} row={row} />
        </nav>
      </header>
      <main id="main" class="page">
        {row.prompt && <p>“{row.prompt}”</p>}
        <div class="sides">
          <div class="stack">
            <Viewer base={folder(row)} label={row.name} onEngine={(found) => (engine.value = found)} />
            <p class="small quiet">
              Drag an object to pull it, release it to throw it<span class="with-keys">; hold Shift to move it horizontally</span>. Drag the background to rotate the view.
            </p>
          </div>
          {engine.value?.ready.value && engine.value.files && (
            <Facts files={engine.value.files} base={folder(row)} selected={engine.value.selected.value} />
          )}
        </div>
      </main>
    </>
  );
}

function Beside({ gallery, row }: { gallery: Gallery; row: SceneRow }) {
  const other = useSignal("");
  return (
    <form
      class="row small"
      onSubmit={(event) => {
        event.preventDefault();
        if (other.value) location.hash = addressOf("beside", row.id, other.value);
      }}
    >
      <label class="row">
        Beside
        <select value={other.value} onChange={(event) => (other.value = event.currentTarget.value)}>
          <option value="">another table</option>
          {gallery.scenes.map((each) => !each.error && each.id !== row.id && <option value={each.id}>{each.name}</option>)}
        </select>
      </label>
      <button disabled={!other.value}>Show</button>
    </form>
  );
}

export function BesidePage({ gallery, rows }: { gallery: Gallery; rows: SceneRow[] }) {
  useTitle(`${rows.map((row) => row.name).join(" and ")} – ${gallery.title}`);
  return (
    <>
      <header class="bar">
        <a href="#/">{gallery.title}</a>
        <h1>{rows.map((row) => row.name).join(" and ")}</h1>
      </header>
      <main id="main" class="page">
        <div class="pair">
          {rows.map((row) => (
            <section key={row.id} class="stack" aria-label={row.name}>
              <h2>{row.name}</h2>
              <p class="small quiet">{row.prompt}</p>
              <Viewer base={folder(row)} label={row.name} small />
            </section>
          ))}
        </div>
      </main>
    </>
  );
}

/** The viewer alone, for a frame in another page; with a task, it plays an episode. */
export function EmbeddedPage({ row, task }: { row: SceneRow; task: string | undefined }) {
  const engine = useSignal<Engine | null>(null);
  useTitle(row.name);
  useEffect(() => {
    const episode = engine.value?.files?.episodes.find((each) => each.task === task);
    if (engine.value?.ready.value && episode) void engine.value.play(episode);
  }, [engine.value?.ready.value, task]);
  return (
    <main id="main" class="embedded">
      <h1 class="hidden">{row.name}</h1>
      <Viewer base={folder(row)} label={row.name} small onEngine={(found) => (engine.value = found)} />
    </main>
  );
}
