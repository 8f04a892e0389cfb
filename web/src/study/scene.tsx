/** One scene: the input picture, the results with their questions, the forced choice (Fig. 18). */
import { useState } from "preact/hooks";
import { download, fileName, postPath, toText } from "./answers";
import type { Page } from "./assignment";
import { Choice } from "./choice";
import { Heading } from "./heading";
import { Criteria } from "./introduction";
import { Rating } from "./rating";
import { focusFirstOpen } from "./steps";
import { countOpen, type Picture, type Store } from "./store";
import { QUESTIONS, type Result } from "./study";
import { View } from "./views";

interface Props {
  store: Store;
  page: Page;
}

export function ScenePage({ store, page }: Props) {
  const [wanted, setWanted] = useState(false);
  const texts = store.texts.value;
  const { place } = store.progress.value;
  const count = store.pages.value.length;
  const open = countOpen(page, store.progress.value);
  const input = { source: page.scene.input, label: texts.input };
  const results = page.results.map((result, k) => picturesOf(store, result, k + 1));
  const all = [input, ...results.flat()];
  const proceed = (): void => {
    setWanted(true);
    if (focusFirstOpen()) return;
    store.go(place + 1);
    if (place === count) handIn(store);
  };
  return (
    <main class="scene">
      <Heading text={texts.scene(place, count)} />
      <details>
        <summary>{texts.criteria}</summary>
        <p>{texts.scale}</p>
        <Criteria texts={texts} />
      </details>
      <div class="columns">
        <figure class="input">
          <figcaption>{texts.input}</figcaption>
          <View store={store} all={all} picture={input} />
        </figure>
        <div class="results">
          {page.results.map((result, k) => (
            <Card
              key={result.id}
              store={store}
              page={page}
              number={k + 1}
              pictures={results[k] ?? []}
              all={all}
              wanted={wanted}
            />
          ))}
          <Choice store={store} page={page} wanted={wanted} />
          <p class="status" role="status">
            {wanted && open ? texts.open(open) : ""}
          </p>
          <div class="actions">
            <button type="button" onClick={() => store.go(place - 1)}>
              {texts.back}
            </button>
            <button type="button" class="primary" data-step="button" onClick={proceed}>
              {place === count ? texts.finish : texts.next}
            </button>
          </div>
        </div>
      </div>
    </main>
  );
}

interface CardProps extends Props {
  number: number;
  pictures: Picture[];
  all: Picture[];
  wanted: boolean;
}

/** A result with its questions. */
function Card({ store, page, number, pictures, all, wanted }: CardProps) {
  const texts = store.texts.value;
  const { marks, checks } = store.progress.value;
  const result = page.results[number - 1];
  if (!result) return null;
  const about = texts.result(number);
  const { check, scene } = page;
  return (
    <section class="card" aria-label={about}>
      <h2>{about}</h2>
      <div class="views">
        {pictures.map((picture) => (
          <View key={picture.label} store={store} all={all} picture={picture} />
        ))}
      </div>
      <div class="questions">
        {QUESTIONS.map((question) => (
          <Rating
            key={question}
            texts={texts}
            id={`${result.id}-${question}`}
            about={about}
            name={texts.questions[question].name}
            question={texts.questions[question].question}
            level={marks[result.id]?.[question]}
            wanted={wanted}
            onAnswer={(level) => store.mark(result.id, question, level)}
          />
        ))}
        {check?.result === result.id ? (
          <Rating
            texts={texts}
            id={`${scene.id}-check`}
            about={about}
            name={texts.checkName}
            question={texts.check(check.asked)}
            level={checks[scene.id]}
            wanted={wanted}
            onAnswer={(level) =>
              store.change({ checks: { ...store.progress.value.checks, [scene.id]: level } })
            }
          />
        ) : null}
      </div>
    </section>
  );
}

function picturesOf(store: Store, result: Result, number: number): Picture[] {
  const texts = store.texts.value;
  const labels = [texts.result(number), texts.resultAbove(number)];
  return result.views.map((source, k) => ({ source, label: labels[k] ?? "" }));
}

/** Saves the answers as a file if no server accepts them. */
function handIn(store: Store): void {
  if (postPath(store.study) !== null) return; // the end's page sends them
  const progress = store.progress.value;
  download(fileName(store.study, progress), toText(store.study, store.pages.value, progress));
}
