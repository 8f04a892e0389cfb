/** A scene of the studio: view it, edit it by mouse or text, save it, try it with the expert. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { addressOf, useTitle } from "../ui/routing";
import { Facts } from "../page/facts";
import type { Engine } from "../viewer/engine";
import type { Move } from "../viewer/placing";
import { Viewer } from "../viewer/viewer";
import { api, type EditRequest, type JobRow, type StudioScene } from "./api";
import { EnvironmentPanel } from "./environment";
import { History } from "./history";
import { attempt, begin, editUnderWay, jobList, refreshScenes, scenes, scenesRead, tell, whenOver, type Message } from "./store";

const STYLES = ["plain", "cartoon", "low-poly"];

/** The request of an edit of the open scene. */
export type Edit = Omit<EditRequest, "kind" | "scene">;

export function EditPage({ id }: { id: string }) {
  const row = scenes.value.find((scene) => scene.id === id);
  const engine = useSignal<Engine | null>(null);
  const busy = useSignal<string | null>(null);
  /** The view and selection for the next step of the history. */
  const kept = useRef<{ view: number[] | null; chosen: string | null }>({ view: null, chosen: null });
  useTitle(`${row?.name ?? "Scene"} – TabletopGen studio`);

  const pending = editUnderWay(id);
  const working = busy.value ?? (pending ? `${pending.title} …` : null);

  const leave = (): void => {
    const left = engine.value;
    kept.current = { view: left?.stage?.view ?? null, chosen: left?.selected.value ?? null };
  };

  const edit = async (asked: Edit): Promise<void> => {
    if (busy.value || editUnderWay(id)) {
      engine.value?.putBack();
      return;
    }
    busy.value = `${asked.action} …`;
    const job = await begin({ kind: "edit", scene: id, ...asked });
    busy.value = null; // from here on the job is under way
    if (!job) engine.value?.putBack();
  };

  /** Opens the result of an edit of this scene, or shows why there is none. */
  const end = async (over: JobRow): Promise<void> => {
    const here = addressOf("scene", id);
    if (over.state === "done" && over.result?.scene) {
      if (location.hash === here) leave();
      await refreshScenes();
      const there = addressOf("scene", over.result.scene);
      const open = (): void => void (location.hash = there);
      const stayed = location.hash === here; // do not navigate if the user has left the page
      if (stayed) open();
      const remedy = stayed ? undefined : { label: "Open it", run: open };
      const lost = (over.result.facts["not_understood"] ?? []) as string[];
      tell([`${over.title}: done; the table has settled and passed its gate.`, ...lost].join(" "), lost.length > 0, remedy);
      return;
    }
    if (location.hash === here) engine.value?.putBack();
    const asked = over.request as EditRequest;
    const said = over.error ?? `The edit was ${over.state}.`;
    const onto = asked.to && over.result?.facts["place"] === "occupied" ? ` To place it on something, write “on the …” under “Move it”.` : "";
    tell(said + onto, true, remedyOf(asked, over, edit));
  };

  useEffect(() => {
    if (pending) void follow(pending.id, end);
  }, [pending?.id]);
  useEffect(() => {
    if (engine.value) engine.value.locked = working !== null;
  }, [engine.value, working]);

  const keep = (found: Engine): void => {
    engine.value = found;
    found.firstView = kept.current.view;
    if (row?.things.some((thing) => thing.name === kept.current.chosen)) found.selected.value = kept.current.chosen;
    found.onMoved = (name, move) => void edit(wordsOf(name, move));
    if (row?.editable) found.edit(true);
  };

  if (!row) return <p class="quiet">{scenesRead.value ? `There is no scene ${id}.` : "Loading the scenes …"}</p>;
  if (row.error) return <p class="message">{row.error}</p>;
  const files = engine.value?.ready.value ? engine.value.files : null;
  return (
    <div class="stack">
      <div class="row">
        <h1>{row.name}</h1>
        <History id={id} leave={leave} />
        {row.in === "workspace" && (
          <button class="primary" aria-disabled={row.saved} onClick={() => row.saved || void save(row)}>
            {row.saved ? "Saved" : "Save to the store"}
          </button>
        )}
      </div>
      {row.prompt && <p class="quiet">“{row.prompt}”</p>}
      <div class="sides">
        <div class="stack">
          <Viewer base={api.folder(id)} label={row.name} onEngine={keep} working={<Working words={working} job={pending} />} />
          {engine.value?.ready.value && <EnvironmentPanel row={row} engine={engine.value} />}
        </div>
        <div class="stack">
          {engine.value?.ready.value && row.editable && <EditPanel engine={engine.value} names={row.things.map((t) => t.name)} off={working !== null || engine.value.mode.value !== "scene"} edit={edit} />}
          <Likeness id={id} />
          {files && <Facts files={files} base={api.folder(id)} selected={engine.value?.selected.value ?? null} />}
        </div>
      </div>
    </div>
  );
}

/** The edits for which this page waits. */
const followed = new Set<string>();

/** Waits for an edit, once, and reports its result. */
async function follow(id: string, end: (over: JobRow) => Promise<void>): Promise<void> {
  if (followed.has(id)) return;
  followed.add(id);
  const over = await whenOver(id);
  followed.delete(id);
  if (over) await end(over);
}

/** The current work on the scene, shown over the view. */
function Working({ words, job }: { words: string | null; job: JobRow | undefined }) {
  return (
    <div class={words ? "working" : ""} role="status">
      {words}
      {job && (
        <button class="slim" onClick={() => void attempt(() => api.cancel(job.id))}>
          Cancel
        </button>
      )}
    </div>
  );
}

/** Similarity of a scene to the picture from which it was generated. */
function Likeness({ id }: { id: string }) {
  const made = jobList.value.find((job) => job.kind === "generate" && job.result?.scene === id);
  const overlap = made?.result?.facts["mean_iou"] as number | null | undefined;
  if (overlap == null) return null;
  return (
    <section class="panel">
      <h2>Likeness to the picture: {overlap.toFixed(2)}</h2>
      <p class="small quiet">Mean overlap of the detected objects, seen from the picture's camera; 1 means identical outlines. Undetected objects are not counted, so compare both pictures.</p>
    </section>
  );
}

async function save({ id, name }: StudioScene): Promise<void> {
  await attempt(async () => {
    await api.save(id);
    await refreshScenes();
    tell(`${name} is now in your store. Open it by name: tabletopgen view ${id}`);
  });
}

export function wordsOf(name: string, move: Move): Edit {
  return { action: "move", words: [name], ...(move.to ? { to: move.to } : {}), ...(move.turn ? { turn: move.turn } : {}) };
}

/** If a place is occupied, the server suggests a free one nearby. */
function remedyOf(asked: Edit, over: JobRow, edit: (asked: Edit) => Promise<void>): Message["remedy"] {
  const to = over.result?.facts["free_position"] as [number, number] | null | undefined;
  if (!to || asked.action !== "move") return undefined;
  return { label: "Place it there", run: () => void edit({ ...asked, to }) };
}

interface EditPanelProps {
  engine: Engine;
  names: string[];
  /** Whether requests are disabled. */
  off: boolean;
  edit: (asked: Edit) => Promise<void>;
}

function EditPanel({ engine, names, off, edit }: EditPanelProps) {
  const chosen = engine.selected.value;
  const turn = useSignal(0);
  const editing = engine.editing.value;
  return (
    <section class="panel" aria-label="Edit">
      <h2>Edit</h2>
      <label class="row">
        <input type="checkbox" checked={editing} disabled={off} onChange={(event) => engine.edit(event.currentTarget.checked)} />
        <span>
          Drag things to new places<span class="with-keys">; Shift turns them</span>
        </span>
      </label>
      <label class="field">
        Thing
        <select value={chosen ?? ""} onChange={(event) => engine.choose(event.currentTarget.value || null)}>
          <option value="">choose one, or click it</option>
          {names.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
      </label>
      {chosen && (
        <>
          <div class="field">
            <span>Turn, degrees counter-clockwise</span>
            <div class="row">
              <input type="number" aria-label="Degrees counter-clockwise" min="-180" max="180" step="5" value={turn.value} onInput={(event) => (turn.value = Number(event.currentTarget.value))} />
              <button disabled={off || turn.value === 0} onClick={() => void edit({ action: "move", words: [chosen], turn: turn.value })}>
                Turn
              </button>
            </div>
          </div>
          <Words label="Move it" hint="left of the laptop" verb="Move" off={off} run={(words) => edit({ action: "move", words: [chosen, words] })} />
          <Words label="Replace it" hint="a teapot" verb="Swap" off={off} run={(words) => edit({ action: "swap", words: [chosen, words] })} />
          <button disabled={off} onClick={() => void edit({ action: "remove", words: [chosen] })}>
            Remove {chosen}
          </button>
        </>
      )}
      <Words label="Add" hint="a red mug left of the laptop" verb="Add" off={off} run={(words) => edit({ action: "add", words: [words] })} />
      <div class="field">
        <span>Style {chosen ? `of ${chosen}` : "of everything"}</span>
        <div class="row">
          {STYLES.map((style) => (
            <button key={style} disabled={off} onClick={() => void edit({ action: "restyle", words: chosen ? [style, chosen] : [style] })}>
              {style}
            </button>
          ))}
        </div>
      </div>
    </section>
  );
}

interface WordsProps {
  label: string;
  hint: string;
  verb: string;
  off: boolean;
  run: (words: string) => Promise<void>;
}

function Words({ label, hint, verb, off, run }: WordsProps) {
  const words = useSignal("");
  return (
    <form
      class="field"
      onSubmit={(event) => {
        event.preventDefault();
        if (words.value.trim()) void run(words.value.trim());
      }}
    >
      <label class="field">
        {label}
        <span class="row">
          <input type="text" maxLength={400} placeholder={hint} value={words.value} onInput={(event) => (words.value = event.currentTarget.value)} />
          <button disabled={off || !words.value.trim()}>{verb}</button>
        </span>
      </label>
    </form>
  );
}
