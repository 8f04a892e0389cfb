/** Undo and redo of a scene's edits. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { addressOf } from "../ui/routing";
import { api, type SceneHistory } from "./api";
import { attempt, scenes } from "./store";

/** The later scene from which this page came back, by scene. */
const cameFrom = new Map<string, string>();

/** Undo to the scene before an edit, and redo to the latest one after it. */
export function History({ id, leave }: { id: string; leave: () => void }) {
  const chain = useSignal<SceneHistory | null>(null);
  useEffect(() => {
    let wanted = true;
    void attempt(async () => {
      const found = await api.history(id);
      if (wanted) chain.value = found;
    });
    return () => {
      wanted = false;
    };
  }, [id, scenes.value]); // another page may have edited it
  const known = chain.value?.scene === id ? chain.value : null;
  const waiting = !known && chain.value !== null; // a disabled button loses the focus
  const before = known?.steps.filter((step) => step.exists && step.id !== id).at(-1)?.id;
  const left = cameFrom.get(id); // the scene that Redo restores, if it still exists
  const after = known?.later.find((later) => later === left) ?? known?.later[0]; // otherwise the newest
  const go = (to: string): void => {
    leave();
    if (to === before) cameFrom.set(to, id);
    location.hash = addressOf("scene", to);
  };
  return (
    <div class="row" role="group" aria-label="History">
      <button disabled={!before && !waiting} aria-disabled={waiting} onClick={() => before && go(before)}>
        Undo
      </button>
      <button disabled={!after && !waiting} aria-disabled={waiting} onClick={() => after && go(after)}>
        Redo
      </button>
    </div>
  );
}
