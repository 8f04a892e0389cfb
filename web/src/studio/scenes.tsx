/** The studio's scenes as cards; some can be selected for comparison. */
import { useSignal } from "@preact/signals";
import { contents, holds } from "../page/search";
import { addressOf } from "../ui/routing";
import { api, type StudioScene } from "./api";
import { attempt, refreshScenes, scenes, scenesRead, tell } from "./store";

const PLACES = { workspace: "made here", store: "in your store", shipped: "shipped" } as const;
/** Labels by kind of a scene's provenance. */
const WAYS: Readonly<Record<string, string>> = { compose: "composed", text: "generated", image: "from a picture" };
const MOST = 4;

export function ScenesPanel({ all = false }: { all?: boolean }) {
  const picked = useSignal<string[]>([]);
  const words = useSignal("");
  const earlier = useSignal(false);
  const mine = scenes.value.filter((row) => (all || row.in === "workspace") && holds(row, words.value));
  const superseded = new Set(scenes.value.map((row) => row.in === "workspace" && row.parent));
  const shown = earlier.value ? mine : mine.filter((row) => row.in !== "workspace" || !superseded.has(row.id));
  const hides = mine.some((row) => row.in === "workspace" && superseded.has(row.id));
  const chosen = picked.value.filter((id) => scenes.value.some((row) => row.id === id)); // some may have been removed
  const choose = (id: string): void => {
    picked.value = chosen.includes(id) ? chosen.filter((other) => other !== id) : [...chosen, id].slice(-MOST);
  };
  return (
    <section class="stack" aria-label="Scenes">
      <div class="row">
        {all ? <h1>Scenes</h1> : <h2>Made here</h2>}
        {all && (
          <label class="row">
            Search
            <input type="search" value={words.value} onInput={(event) => (words.value = event.currentTarget.value)} />
          </label>
        )}
        {chosen.length > 1 && (
          <a class="button" href={addressOf("compare", ...chosen)}>
            Compare {chosen.length} side by side
          </a>
        )}
        {hides && (
          <label class="row small">
            <input type="checkbox" checked={earlier.value} onChange={(event) => (earlier.value = event.currentTarget.checked)} />
            Show earlier versions
          </label>
        )}
        {!all && <a href="#/scenes">All scenes</a>}
      </div>
      {shown.length === 0 && <p class="quiet">{scenesRead.value ? "No scenes yet." : "Loading the scenes …"}</p>}
      <ul class="cards">
        {shown.map((row) => (
          <li key={row.id}>
            <SceneCard row={row} chosen={chosen.includes(row.id)} onChoose={() => choose(row.id)} />
          </li>
        ))}
      </ul>
    </section>
  );
}

/** The number of edits of a scene, and the last one. */
export function Edits({ row }: { row: StudioScene }) {
  if (row.edits === 0) return null;
  return (
    <p class="small">
      {row.edits === 1 ? "1 edit" : `${row.edits} edits, the last`}: {row.last_edit}
    </p>
  );
}

function SceneCard({ row, chosen, onChoose }: { row: StudioScene; chosen: boolean; onChoose: () => void }) {
  const remove = async (): Promise<void> => {
    if (!confirm(`Remove ${row.name} from the studio's folder?`)) return;
    await attempt(async () => {
      await api.discard(row.id);
      tell(`${row.name} was removed.`);
      await refreshScenes();
    });
  };
  return (
    <article class="card">
      {row.error ? <div class="picture" /> : <img class="picture" loading="lazy" alt="" src={row.thumbnail ?? ""} />}
      <div class="text">
        <h3>{row.error ? row.name : <a href={addressOf("scene", row.id)}>{row.name}</a>}</h3>
        {row.error ? <p class="bad small">{row.error}</p> : <p class="small quiet">{contents(row)}</p>}
        <Edits row={row} />
        <div class="tags">
          <span class="tag">{PLACES[row.in]}</span>
          {row.in === "workspace" && WAYS[row.kind] && <span class="tag">{WAYS[row.kind]}</span>}
          {row.saved && row.in === "workspace" && <span class="tag good">saved</span>}
          {row.seed !== null && <span class="tag">seed {row.seed}</span>}
          {row.gate && <span class={`tag ${row.gate.passed ? "good" : "bad"}`}>gate {row.gate.passed ? "passed" : "failed"}</span>}
        </div>
        <div class="row">
          {!row.error && (
            <label class="row small">
              <input type="checkbox" checked={chosen} onChange={onChoose} aria-label={`Compare ${row.name}`} />
              Compare
            </label>
          )}
          {row.in === "workspace" && (
            <button class="slim" aria-label={`Remove ${row.name}`} onClick={() => void remove()}>
              Remove
            </button>
          )}
        </div>
      </div>
    </article>
  );
}
