/** The end: answers are sent, or saved as a file; both can be repeated. */
import { useEffect, useState } from "preact/hooks";
import { download, fileName, post, postPath, toText } from "./answers";
import { Heading } from "./heading";
import type { Store } from "./store";

export function End({ store }: { store: Store }) {
  const texts = store.texts.value;
  const progress = store.progress.value;
  const name = fileName(store.study, progress);
  const path = postPath(store.study);
  return (
    <main class="text">
      <Heading text={texts.thanks} />
      <p>{texts.done}</p>
      {path === null ? <p>{texts.saved(name)}</p> : <Sending store={store} path={path} />}
      <div class="actions">
        <button
          type="button"
          class={path === null ? "primary" : ""}
          onClick={() => download(name, toText(store.study, store.pages.value, progress))}
        >
          {texts.download}
        </button>
      </div>
    </main>
  );
}

/** Sends the answers when it appears, and again on request. */
function Sending({ store, path }: { store: Store; path: string }) {
  const [failed, setFailed] = useState(false);
  const texts = store.texts.value;
  const { sent } = store.progress.value;
  const send = async (): Promise<void> => {
    setFailed(false);
    const { rater } = store.progress.value;
    const took = await post(path, toText(store.study, store.pages.value, store.progress.value));
    if (store.progress.value.rater !== rater) return; // another rater has started meanwhile
    if (took) store.change({ sent: true });
    else setFailed(true);
  };
  useEffect(() => {
    if (!store.progress.value.sent) void send();
  }, []);
  return (
    <>
      <p role="status">{sent ? texts.sent : failed ? "" : texts.sending}</p>
      <p role="alert">{failed ? texts.notSent : ""}</p>
      {failed ? (
        <div class="actions">
          <button type="button" class="primary" onClick={() => void send()}>
            {texts.again}
          </button>
        </div>
      ) : null}
    </>
  );
}
