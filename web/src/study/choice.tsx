/** The forced choice among a scene's results (Fig. 19). */
import type { Page } from "./assignment";
import { digitOf, focusNext } from "./steps";
import type { Store } from "./store";

interface Props {
  store: Store;
  page: Page;
  wanted: boolean;
}

export function Choice({ store, page, wanted }: Props) {
  const texts = store.texts.value;
  const { choices } = store.progress.value;
  const { scene, results } = page;
  const chosen = choices[scene.id];
  const missing = wanted && chosen === undefined;
  const choose = (result: string): void =>
    store.change({ choices: { ...store.progress.value.choices, [scene.id]: result } });
  return (
    <fieldset
      class={missing ? "question choice open" : "question choice"}
      data-step={chosen === undefined ? "open" : "done"}
      data-question={`${scene.id}-choice`}
      onKeyDown={(event) => {
        const result = results[(digitOf(event, results.length) ?? 0) - 1];
        if (!result) return;
        event.preventDefault();
        choose(result.id);
        focusNext(event.currentTarget);
      }}
    >
      <legend>
        <strong>{texts.choice}</strong>
        {missing ? <em> {texts.unanswered}</em> : null}
      </legend>
      <div class="choices">
        {results.map((result, k) => (
          <label key={result.id}>
            <input
              type="radio"
              name={`${scene.id}-choice`}
              value={result.id}
              checked={chosen === result.id}
              onChange={() => choose(result.id)}
            />
            <span class="level">
              <img src={result.views[0]} alt="" />
              {texts.result(k + 1)}
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
