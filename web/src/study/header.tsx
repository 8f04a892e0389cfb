/** The study's title, the rater's progress, the language, and a button to start over. */
import { useRef } from "preact/hooks";
import type { Store } from "./store";
import { LANGUAGES, TEXTS } from "./texts";

export function Header({ store }: { store: Store }) {
  const texts = store.texts.value;
  const { place } = store.progress.value;
  const count = store.pages.value.length;
  const at = Math.min(Math.max(place - 1, 0), count);
  return (
    <header>
      <p class="title">{store.study.title || texts.title}</p>
      {place > 0 ? (
        <progress
          max={count}
          value={at}
          aria-label={texts.scene(Math.min(place, count), count)}
        />
      ) : null}
      <div class="tools">
        <Languages store={store} />
        {place > 0 ? <StartOver store={store} /> : null}
      </div>
    </header>
  );
}

function Languages({ store }: { store: Store }) {
  const used = store.progress.value.language;
  return (
    <div role="group" aria-label={store.texts.value.language} class="languages">
      {LANGUAGES.map((language) => (
        <button
          key={language}
          type="button"
          class="quiet"
          lang={language}
          aria-pressed={language === used}
          onClick={() => store.setLanguage(language)}
        >
          {TEXTS[language].name}
        </button>
      ))}
    </div>
  );
}

function StartOver({ store }: { store: Store }) {
  const texts = store.texts.value;
  const dialog = useRef<HTMLDialogElement>(null);
  const close = (): void => dialog.current?.close();
  return (
    <>
      <button type="button" class="quiet" onClick={() => dialog.current?.showModal()}>
        {texts.startOver}
      </button>
      <dialog ref={dialog} class="question-dialog" aria-labelledby="start-over">
        <h2 id="start-over">{texts.startOver}</h2>
        <p>{texts.startOverWarning}</p>
        <div class="actions">
          <button type="button" onClick={close}>
            {texts.cancel}
          </button>
          <button
            type="button"
            class="primary"
            onClick={() => {
              close();
              store.startOver();
            }}
          >
            {texts.startOverYes}
          </button>
        </div>
      </dialog>
    </>
  );
}
