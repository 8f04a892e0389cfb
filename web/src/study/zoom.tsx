/** An enlarged picture, with controls for the scene's other pictures. */
import { useEffect, useRef, useState } from "preact/hooks";
import type { Store } from "./store";

const SCALES = [1, 1.5, 2, 3, 4] as const;

export function ZoomDialog({ store }: { store: Store }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const stage = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState(0);
  const zoom = store.zoom.value;
  const texts = store.texts.value;
  const opened = zoom !== null;
  useEffect(() => {
    if (opened && !dialog.current?.open) {
      setSize(0);
      dialog.current?.showModal();
    }
    if (!opened) dialog.current?.close();
  }, [opened]);
  useEffect(() => {
    const box = stage.current;
    if (!box) return; // otherwise its middle stays in view
    box.scrollLeft = (box.scrollWidth - box.clientWidth) / 2;
    box.scrollTop = (box.scrollHeight - box.clientHeight) / 2;
  }, [size]);
  const picture = zoom?.pictures[zoom.at];
  const turn = (by: number): void => {
    if (!zoom) return;
    const count = zoom.pictures.length;
    store.zoom.value = { ...zoom, at: (zoom.at + by + count) % count };
  };
  const resize = (by: number): void =>
    setSize((now) => Math.min(Math.max(now + by, 0), SCALES.length - 1));
  const keys: Record<string, () => void> = {
    ArrowLeft: () => turn(-1),
    ArrowRight: () => turn(1),
    "+": () => resize(1),
    "=": () => resize(1),
    "-": () => resize(-1),
  };
  return (
    <dialog
      ref={dialog}
      class="zoom"
      aria-label={picture?.label ?? ""}
      onClose={() => {
        store.zoom.value = null;
      }}
      onKeyDown={(event) => {
        const act = event.ctrlKey || event.altKey || event.metaKey ? undefined : keys[event.key];
        const scrolls = size > 0 && event.target === stage.current;
        if (!act || (scrolls && event.key.startsWith("Arrow"))) return;
        event.preventDefault();
        act();
      }}
    >
      <div class="bar">
        <button type="button" aria-label={texts.previous} onClick={() => turn(-1)}>
          ←
        </button>
        <p role="status">{picture?.label}</p>
        <button type="button" aria-label={texts.following} onClick={() => turn(1)}>
          →
        </button>
        <button type="button" aria-label={texts.smaller} onClick={() => resize(-1)}>
          −
        </button>
        <button type="button" aria-label={texts.larger} onClick={() => resize(1)}>
          +
        </button>
        <button type="button" onClick={() => dialog.current?.close()}>
          {texts.close}
        </button>
      </div>
      <div ref={stage} class="stage" tabIndex={0} role="group" aria-label={picture?.label ?? ""}>
        {picture ? (
          <img
            src={picture.source}
            alt={picture.label}
            style={{ width: `${100 * (SCALES[size] ?? 1)}%`, height: `${100 * (SCALES[size] ?? 1)}%` }}
          />
        ) : null}
      </div>
    </dialog>
  );
}
