/** The robot's tools: driving it, or watching an episode. */
import { useSignal } from "@preact/signals";
import { KEYS } from "./driving";
import type { Engine } from "./engine";

export function Robot({ engine, off }: { engine: Engine; off: boolean }) {
  if (!engine.ready.value || !engine.files?.arm) return null;
  const mode = engine.mode.value;
  const { episodes } = engine.files;
  const see = async (work: Promise<void>): Promise<void> => {
    await work;
    const canvas = engine.stage?.renderer.domElement;
    canvas?.focus({ preventScroll: true }); // it handles the arm's keys
    canvas?.scrollIntoView({ block: "nearest", behavior: "smooth" });
  };
  return (
    <div class="stack">
      {mode === "episode" && <Timeline engine={engine} />}
      {mode === "arm" && <Pad engine={engine} />}
      <div class="tools" role="group" aria-label="Robot">
        <button disabled={off} aria-pressed={mode === "arm"} onClick={() => void see(engine.setMode(mode === "arm" ? "scene" : "arm"))}>
          Drive the Panda
        </button>
        {episodes.map((row) => (
          <button key={row.file} disabled={off} aria-pressed={mode === "episode" && engine.player.playback.value?.episode.instruction === row.instruction} onClick={() => void see(engine.play(row))}>
            Watch: {row.instruction}
          </button>
        ))}
        {mode === "episode" && <button onClick={() => void engine.setMode("scene")}>Back to the scene</button>}
      </div>
    </div>
  );
}

/** The episode's instruction and the current time. */
export function Timeline({ engine }: { engine: Engine }) {
  const play = engine.player.playback.value;
  if (!play) return null;
  return (
    <label class="row">
      <span class="small">{play.episode.instruction}</span>
      <input
        class="grow"
        style={{ flex: "1 1 10rem" }}
        type="range"
        min="0"
        max={play.duration}
        step="0.05"
        aria-label="Time in the episode, seconds"
        value={Math.min(engine.player.time.value, play.duration)}
        onInput={(event) => engine.player.seek(Number(event.currentTarget.value))}
      />
      <span class="small quiet">
        {play.duration.toFixed(1)} s, {play.episode.success ? "solved" : "not solved"}
      </span>
    </label>
  );
}

/** Milliseconds. */
const NUDGE = 250;

const PAD: readonly [string, string, string][] = [
  ["q", "↺", "turn the hand left"],
  ["w", "↑", "away from you"],
  ["e", "↻", "turn the hand right"],
  ["r", "Up", "up"],
  ["a", "←", "left"],
  ["s", "↓", "towards you"],
  ["d", "→", "right"],
  ["f", "Down", "down"],
];

/** Enter and Space hold a button down, like the pointer. */
function heed(engine: Engine, key: string, event: KeyboardEvent, down: boolean): void {
  if (event.key !== "Enter" && event.key !== " ") return;
  event.preventDefault();
  engine.press(key, down);
}

/** Presses a button briefly: a screen reader's click does not hold it. */
function nudge(engine: Engine, key: string): void {
  engine.press(key, true);
  setTimeout(() => engine.press(key, false), NUDGE);
}

function Pad({ engine }: { engine: Engine }) {
  const help = useSignal(false);
  return (
    <div class="stack">
      <div class="pad" role="group" aria-label="Drive the arm">
        {PAD.map(([key, sign, words]) => (
          <button
            key={key}
            aria-label={words}
            title={words}
            onPointerDown={() => engine.press(key, true)}
            onPointerUp={() => engine.press(key, false)}
            onPointerLeave={() => engine.press(key, false)}
            onKeyDown={(event) => heed(engine, key, event, true)}
            onKeyUp={(event) => heed(engine, key, event, false)}
            onBlur={() => engine.press(key, false)}
            onClick={(event) => event.detail === 0 && nudge(engine, key)}
          >
            {sign}
          </button>
        ))}
      </div>
      <div class="tools">
        <button aria-pressed={engine.gripper.value === "closed"} onClick={() => engine.press(" ", true)}>
          {engine.gripper.value === "open" ? "Close the gripper" : "Open the gripper"}
        </button>
        <button aria-expanded={help.value} onClick={() => (help.value = !help.value)}>
          Keys
        </button>
      </div>
      {help.value && (
        <p class="small">
          With the view focused:{" "}
          {KEYS.map(([keys, words], k) => (
            <span key={keys}>
              {k > 0 && ", "}
              <kbd>{keys}</kbd> {words}
            </span>
          ))}
        </p>
      )}
    </div>
  );
}
