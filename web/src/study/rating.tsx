/** One question with its seven levels as radio buttons, also set by digit keys. */
import { digitOf, focusNext } from "./steps";
import { LEVELS } from "./study";
import type { Texts } from "./texts";

interface Props {
  texts: Texts;
  /** Name of the radio buttons; unique in the page. */
  id: string;
  /** The rated result. */
  about: string;
  name: string;
  question: string;
  level: number | undefined;
  /** Whether to show that the answer is missing. */
  wanted: boolean;
  onAnswer: (level: number) => void;
}

export function Rating({ texts, id, about, name, question, level, wanted, onAnswer }: Props) {
  const missing = wanted && level === undefined;
  return (
    <fieldset
      class={missing ? "question open" : "question"}
      data-step={level === undefined ? "open" : "done"}
      data-question={id}
      onKeyDown={(event) => {
        const digit = digitOf(event, LEVELS.length);
        if (digit === null) return;
        event.preventDefault();
        onAnswer(digit);
        focusNext(event.currentTarget);
      }}
    >
      <legend>
        <span class="hidden">{about}: </span>
        <strong>{name}</strong> {question}
        {missing ? <em> {texts.unanswered}</em> : null}
      </legend>
      <div class="levels">
        {LEVELS.map((value) => (
          <label key={value}>
            <input
              type="radio"
              name={id}
              value={value}
              checked={level === value}
              onChange={() => onAnswer(value)}
            />
            <span class="level">
              {value}
              <Meaning texts={texts} level={value} />
            </span>
          </label>
        ))}
      </div>
      <div class="meanings" aria-hidden="true">
        <span>{texts.levels[1]}</span>
        <span>{texts.levels[4]}</span>
        <span>{texts.levels[7]}</span>
      </div>
    </fieldset>
  );
}

/** Meaning of a level, for users who do not see the row below. */
function Meaning({ texts, level }: { texts: Texts; level: number }) {
  const meaning = level === 1 || level === 4 || level === 7 ? texts.levels[level] : null;
  return meaning ? <span class="hidden">, {meaning}</span> : null;
}
