/** The whole page: a header, and the introduction, a scene or the end. */
import { useEffect } from "preact/hooks";
import { End } from "./end";
import { Header } from "./header";
import { Introduction } from "./introduction";
import { ScenePage } from "./scene";
import type { Store } from "./store";
import { ZoomDialog } from "./zoom";

export function App({ store }: { store: Store }) {
  const { place } = store.progress.value;
  const texts = store.texts.value;
  const page = store.pages.value[place - 1];
  useEffect(() => {
    document.title = store.study.title || texts.title;
  }, [texts]);
  return (
    <>
      <Header store={store} />
      {store.kept.value ? null : (
        <p class="notice" role="alert">
          {texts.notKept}
        </p>
      )}
      {place === 0 ? (
        <Introduction store={store} />
      ) : page ? (
        <ScenePage key={page.scene.id} store={store} page={page} />
      ) : (
        <End store={store} />
      )}
      <ZoomDialog store={store} />
    </>
  );
}
