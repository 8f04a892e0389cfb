/** Purpose and instructions of the study (Fig. 17). */
import { Heading } from "./heading";
import type { Store } from "./store";
import { QUESTIONS } from "./study";
import type { Texts } from "./texts";

export function Introduction({ store }: { store: Store }) {
  const texts = store.texts.value;
  const pages = store.pages.value;
  const started = Object.keys(store.progress.value.seconds).length > 0;
  return (
    <main class="text">
      <Heading text={texts.thanks} />
      {texts.welcome.map((text) => (
        <p key={text}>{text}</p>
      ))}
      {texts.task(pages.length, pages[0]?.results.length ?? 0).map((text) => (
        <p key={text}>{text}</p>
      ))}
      <p>
        <strong>{texts.scale}</strong>
      </p>
      <h2>{texts.criteria}</h2>
      <Criteria texts={texts} />
      {store.study.attention ? <p>{texts.checks}</p> : null}
      <p>{texts.keyboard}</p>
      {store.kept.value ? <p>{texts.resume}</p> : null}
      <div class="actions">
        <button type="button" class="primary" onClick={() => store.go(1)}>
          {started ? texts.proceed : texts.begin}
        </button>
      </div>
    </main>
  );
}

/** The criteria, each with its question and aspects to consider (Fig. 18). */
export function Criteria({ texts }: { texts: Texts }) {
  return (
    <dl class="criteria">
      {QUESTIONS.map((question) => (
        <div key={question}>
          <dt>{texts.questions[question].name}</dt>
          <dd>
            {texts.questions[question].question} {texts.questions[question].consider}
          </dd>
        </div>
      ))}
    </dl>
  );
}
