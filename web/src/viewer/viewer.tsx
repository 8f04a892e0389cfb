/** A scene in the page: the canvas, its tools, and errors. */
import { useComputed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { ROBOT } from "../physics/names";
import { Engine } from "./engine";
import { Robot, Timeline } from "./robot";

export interface ViewerProps {
  /** The scene's folder, with a slash at its end. */
  base: string;
  label: string;
  /** Reduced version to embed in another page: no arm, no picture. */
  small?: boolean;
  onEngine?: (engine: Engine) => void;
  /** Content shown over the view while the scene changes. */
  working?: ComponentChildren;
}

declare global {
  interface Window {
    /** The live scenes of this page by folder, for scripts and tests. */
    tabletopgen?: Map<string, Engine>;
  }
}

export function Viewer({ base, label, small = false, onEngine, working }: ViewerProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const engine = useMemo(() => new Engine(), [base]);
  useEffect(() => {
    if (canvas.current) engine.attach(canvas.current);
    const known = (window.tabletopgen ??= new Map<string, Engine>());
    known.set(base, engine);
    onEngine?.(engine);
    if (!engine.error.value) void engine.open(base);
    return () => {
      known.delete(base);
      engine.close();
    };
  }, [engine]);
  const loading = useComputed(() => !engine.ready.value && !engine.error.value);
  return (
    <div class="viewer">
      <div class="view">
        <canvas
          key={base}
          ref={canvas}
          tabIndex={0}
          role="application"
          aria-label={`3D view of ${label}. Arrow keys turn the view, plus and minus zoom, space plays or pauses.`}
          onKeyDown={(event) => heed(engine, event)}
          onKeyUp={(event) => engine.key(event, false) && event.preventDefault()}
          onBlur={() => engine.releaseKeys()}
        />
        <Overlays engine={engine} base={base} />
        {working}
        {loading.value && (
          <div class="over" role="status">
            Loading the scene …
          </div>
        )}
      </div>
      <Tools engine={engine} small={small} />
    </div>
  );
}

function Overlays({ engine, base }: { engine: Engine; base: string }) {
  const picture = engine.ready.value ? engine.files?.picture : null;
  const hover = engine.hover.value;
  return (
    <>
      {picture && engine.onion.value > 0 && (
        <img class="onion" alt="" src={base + picture.file} style={{ opacity: engine.onion.value }} />
      )}
      {hover && (
        <span class="name" style={{ left: `${hover.x}px`, top: `${hover.y}px` }}>
          {hover.name.replace(ROBOT, "robot: ")}
          {engine.blocked.value && `: ${engine.blocked.value}`}
        </span>
      )}
      {engine.ready.value && <Clock engine={engine} />}
      {(engine.error.value ?? engine.trouble.value) && (
        <div class="over" role="alert">
          <p>{engine.error.value ?? engine.trouble.value}</p>
          {!engine.error.value && <button onClick={() => void engine.recover()}>Back to the scene</button>}
        </div>
      )}
    </>
  );
}

function Clock({ engine }: { engine: Engine }) {
  const time = engine.mode.value === "episode" ? engine.player.time.value : engine.time.value;
  return <span class="clock">{time.toFixed(1)} s</span>;
}

/** Space plays or pauses, arrow keys rotate the camera; with the arm at the table, its keys drive. */
function heed(engine: Engine, event: KeyboardEvent): void {
  if (engine.key(event, true)) {
    event.preventDefault();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const turns: Record<string, [number, number]> = {
    ArrowLeft: [-0.1, 0],
    ArrowRight: [0.1, 0],
    ArrowUp: [0, -0.07],
    ArrowDown: [0, 0.07],
  };
  const turn = turns[event.key];
  if (turn) engine.stage?.turn(...turn);
  else if (event.key === "+" || event.key === "=") engine.stage?.zoom(0.9);
  else if (event.key === "-") engine.stage?.zoom(1 / 0.9);
  else if (event.key === " ") engine.toggle();
  else return;
  event.preventDefault();
}

function Tools({ engine, small }: { engine: Engine; small: boolean }) {
  const off = !engine.ready.value || engine.error.value !== null || engine.trouble.value !== null;
  const mode = engine.mode.value;
  const running = mode === "episode" ? engine.player.playing.value : engine.running.value;
  return (
    <div class="stack">
      {!small && mode !== "scene" && <Robot engine={engine} off={off} />}
      {small && mode === "episode" && <Timeline engine={engine} />}
      <div class="tools" role="toolbar" aria-label="Simulation">
        <button disabled={off} onClick={() => engine.toggle()}>
          {running ? "Pause" : "Play"}
        </button>
        <button disabled={off || mode === "episode"} onClick={() => engine.step(10)}>
          Step
        </button>
        <button disabled={off} onClick={() => engine.restart()}>
          Reset
        </button>
        <span class="gap" />
        <button disabled={off} onClick={() => engine.lookFrom("front")}>
          Overview
        </button>
        <button disabled={off} onClick={() => engine.lookFrom("top")}>
          Above
        </button>
        {!small && <Picture engine={engine} off={off} />}
        <span class="gap" />
        <Toggle engine={engine} what="parts" off={off}>
          Collision parts
        </Toggle>
        <Toggle engine={engine} what="centres" off={off}>
          Centres of mass
        </Toggle>
        <Toggle engine={engine} what="contacts" off={off}>
          Contacts
        </Toggle>
      </div>
      {!small && mode === "scene" && <Robot engine={engine} off={off} />}
    </div>
  );
}

function Toggle(props: { engine: Engine; what: "parts" | "centres" | "contacts"; off: boolean; children: string }) {
  const { engine, what, off, children } = props;
  const on = engine[what].value;
  return (
    <button disabled={off} aria-pressed={on} onClick={() => engine.setShown(what, !on)}>
      {children}
    </button>
  );
}

function Picture({ engine, off }: { engine: Engine; off: boolean }) {
  const picture = engine.ready.value ? engine.files?.picture : null;
  if (!picture) return null;
  const word = picture.kind === "reference" ? "Picture" : "Render";
  return (
    <>
      <button disabled={off} aria-pressed={engine.inPicture.value} onClick={() => engine.lookAsPicture(0.5)}>
        As the {word.toLowerCase()}
      </button>
      {engine.inPicture.value && (
        <label>
          {word} over the view
          <input
            type="range"
            min="0"
            max="1"
            step="0.05"
            value={engine.onion.value}
            onInput={(event) => engine.lookAsPicture(Number(event.currentTarget.value))}
          />
        </label>
      )}
    </>
  );
}
