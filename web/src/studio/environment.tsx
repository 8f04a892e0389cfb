/** The environment at a scene: the expert plays a task, and the episode is shown. */
import { useSignal } from "@preact/signals";
import type { Engine } from "../viewer/engine";
import type { Format, StudioScene } from "./api";
import { attempt, begin, studio, tell, whenOver } from "./store";

export function EnvironmentPanel({ row: { id, in: place, saved }, engine }: { row: StudioScene; engine: Engine }) {
  const task = useSignal("PickPlace");
  const seed = useSignal(0);
  const busy = useSignal(false);
  const format = useSignal<Format>("glb");
  const known = studio.value;
  if (!known || !engine.files?.arm) return null;

  const watch = async (): Promise<void> => {
    busy.value = true;
    const job = await begin({ kind: "episode", scene: id, task: task.value, seed: seed.value });
    const over = job && (await whenOver(job.id));
    busy.value = false;
    const url = over?.state === "done" ? over.result?.url : null;
    if (url) {
      await attempt(() => engine.playFile(url));
      engine.stage?.renderer.domElement.scrollIntoView({ block: "center", behavior: "smooth" });
    }
    else if (over) tell(`The expert cannot play ${task.value} here. ${over.error ?? `The episode ${over.state}.`}`, true);
  };
  const write = async (): Promise<void> => {
    busy.value = true;
    const job = await begin({ kind: "export", scene: id, format: format.value });
    const over = job && (await whenOver(job.id));
    busy.value = false;
    const url = over?.state === "done" ? over.result?.url : null;
    if (url) {
      const fetchIt = (): void => location.assign(url);
      fetchIt();
      tell(`${over?.result?.file} was created, and its download has started.`, false, { label: "Download it again", run: fetchIt });
    }
    else if (over) tell(over.error ?? `The export ${over.state}.`, true);
  };
  return (
    <section class="panel" aria-label="Environment">
      <h2>In the environment</h2>
      <div class="filters">
        <label>
          Task
          <select value={task.value} onChange={(event) => (task.value = event.currentTarget.value)}>
            {known.tasks.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
        <label>
          Seed
          <input type="number" min="0" step="1" value={seed.value} onInput={(event) => (seed.value = Math.max(0, Math.trunc(Number(event.currentTarget.value) || 0)))} />
        </label>
        <button disabled={busy.value} onClick={() => void watch()}>
          {busy.value ? "The expert plays …" : "Watch the expert"}
        </button>
        <label>
          Export as
          <select value={format.value} onChange={(event) => (format.value = event.currentTarget.value as Format)}>
            {known.formats.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
        <button disabled={busy.value} onClick={() => void write()}>
          Export
        </button>
      </div>
      <p class="small quiet">
        In Python{place === "workspace" && !saved && ", once it is saved"}: <code>{`gymnasium.make("tabletopgen_env:TabletopGen/${task.value}-v0", scenes="${id}")`}</code>
      </p>
    </section>
  );
}
