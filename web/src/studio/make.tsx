/** The form for a new table: a text or a picture, backends, and a cost estimate. */
import { signal, useSignal, type Signal } from "@preact/signals";
import { api, type EstimateRow, type JobRequest, type Paid, type PictureRow, type Role } from "./api";
import { attempt, begin, message, studio, tell } from "./store";
import { Understood } from "./understood";

type Way = "compose" | "generate";

const MOST_VARIANTS = 8;

/** Outlives the form, to keep the user's choice. */
const way = signal<Way>("compose");

export function MakeForm() {
  const text = useSignal("");
  const picture = useSignal<PictureRow | null>(null);
  const seed = useSignal(0);
  const variants = useSignal(1);
  const backends = useSignal<Record<string, string>>({});
  const budget = useSignal("");
  const estimate = useSignal<EstimateRow | null>(null);
  /** The request of `estimate` as JSON: the estimate is invalid for any other request. */
  const estimated = useSignal("");
  const busy = useSignal(false);
  const kind = (): Way => (picture.value ? "generate" : way.value);
  /** Whether the embedded planner reads the text: the interpretation of other planners is unknown beforehand. */
  const embedded = (): boolean => !picture.value && !(kind() === "generate" && backends.value["reasoner"]);

  const request = (number: number): JobRequest => {
    const described = picture.value ? { picture: picture.value.picture } : { text: text.value.trim() };
    if (kind() === "compose") return { kind: "compose", text: text.value.trim(), seed: number };
    const paid: Paid = { ...backends.value, ...(budget.value ? { budget: Number(budget.value) } : {}) };
    return { kind: "generate", seed: number, ...described, ...paid };
  };

  const current = (): string => JSON.stringify(request(seed.value));

  const reckon = async (): Promise<void> => {
    const asked = current();
    estimated.value = asked;
    estimate.value = null;
    const found = await attempt(() => api.estimate(request(seed.value)));
    if (estimated.value === asked) estimate.value = found ?? null;
  };

  const submit = async (event: Event): Promise<void> => {
    event.preventDefault();
    if (!picture.value && !text.value.trim()) {
      tell("Describe a table, or drop a picture of one.", true);
      return;
    }
    busy.value = true;
    if (kind() === "generate" && charges(backends.value) && estimated.value !== current()) {
      await reckon();
      busy.value = false;
      if (estimate.value) tell("The selected backends cost money. Check the costs, then press the button again.");
      return;
    }
    const begun = [];
    for (let k = 0; k < variants.value; k++) {
      const job = await begin(request(seed.value + k));
      if (!job) break; // the others would be rejected, too
      begun.push(job);
    }
    busy.value = false;
    const first = begun[0];
    if (first && variants.value === 1) location.hash = `#/job/${first.id}`;
    else if (first) tell(`${begun.length} tables are being made. They will appear under “Made here”, where you can compare them.`);
  };

  return (
    <form class="panel" onSubmit={(event) => void submit(event)}>
      <label class="stack">
        Describe the table
        <textarea
          rows={4}
          maxLength={4000}
          placeholder="A wooden desk with a laptop, two mugs and a plant behind the laptop"
          value={text.value}
          disabled={picture.value !== null}
          onInput={(event) => {
            text.value = event.currentTarget.value;
            if (message.value?.bad) message.value = null; // it was about the previous text
          }}
        />
      </label>
      <Understood text={embedded() ? text.value.trim() : ""} seed={seed.value} />
      <Drop picture={picture} />
      {!picture.value && (
        <fieldset>
          <legend>Method</legend>
          <label class="row">
            <input type="radio" name="way" checked={way.value === "compose"} onChange={() => (way.value = "compose")} />
            Compose: from the catalogue, in seconds
          </label>
          <label class="row">
            <input type="radio" name="way" checked={way.value === "generate"} onChange={() => (way.value = "generate")} />
            Generate: the full method with an intermediate picture, about half a minute
          </label>
        </fieldset>
      )}
      <div class="filters">
        <label>
          Seed
          <input type="number" min="0" max="2147483647" step="1" value={seed.value} onInput={(event) => (seed.value = Math.max(0, Math.trunc(Number(event.currentTarget.value) || 0)))} />
        </label>
        <label>
          Variants
          <input
            type="number"
            min="1"
            max={MOST_VARIANTS}
            step="1"
            value={variants.value}
            onInput={(event) => (variants.value = Math.min(Math.max(1, Math.trunc(Number(event.currentTarget.value) || 1)), MOST_VARIANTS))}
          />
        </label>
      </div>
      {kind() === "generate" && <Backends chosen={backends} budget={budget} />}
      <div class="row">
        <button class="primary" type="submit" disabled={busy.value}>
          {variants.value > 1 ? `Make ${variants.value} tables` : "Make the table"}
        </button>
        {kind() === "generate" && (
          <button type="button" onClick={() => void reckon()}>
            Estimate the cost
          </button>
        )}
      </div>
      {estimate.value && kind() === "generate" && estimated.value === current() && (
        <Costs estimate={estimate.value} tables={variants.value} />
      )}
    </form>
  );
}

/** Returns whether one of the selected backends costs money. */
function charges(chosen: Record<string, string>): boolean {
  return studio.value?.backends.some((b) => b.charges && Object.values(chosen).includes(b.name)) ?? false;
}

function Drop({ picture }: { picture: Signal<PictureRow | null> }) {
  const over = useSignal(false);
  const busy = useSignal(false);
  const take = async (file: File | undefined): Promise<void> => {
    if (!file) return;
    busy.value = true;
    const found = await attempt(() => api.upload(file));
    busy.value = false;
    if (!found) return;
    picture.value = found;
    if (message.value?.bad) message.value = null; // it was about another file
  };
  if (picture.value) {
    return (
      <div class="row">
        <img class="thumb" src={api.picture(picture.value.picture)} alt="The input picture" />
        <span class="small quiet">
          {picture.value.width} × {picture.value.height}
        </span>
        <button type="button" onClick={() => (picture.value = null)}>
          Use a text instead
        </button>
      </div>
    );
  }
  return (
    <label
      class={over.value ? "drop over" : "drop"}
      onDragOver={(event) => {
        event.preventDefault();
        over.value = true;
      }}
      onDragLeave={() => (over.value = false)}
      onDrop={(event) => {
        event.preventDefault();
        over.value = false;
        void take(event.dataTransfer?.files[0]);
      }}
    >
      {busy.value ? "Uploading the picture …" : "or drop a picture of a tabletop here, or choose one"}
      <input type="file" accept="image/png,image/jpeg,image/webp" onChange={(event) => {
          const input = event.currentTarget;
          void take(input.files?.[0]).then(() => (input.value = "")); // clear a rejected file
        }}
      />
    </label>
  );
}

function Backends({ chosen, budget }: { chosen: Signal<Record<string, string>>; budget: Signal<string> }) {
  const known = studio.value;
  if (!known) return null;
  const set = (role: Role, name: string): void => {
    const { [role]: _, ...rest } = chosen.value;
    chosen.value = name ? { ...rest, [role]: name } : rest;
  };
  return (
    <details>
      <summary>Backends</summary>
      <div class="filters">
        {known.roles.map((role) => (
          <label key={role}>
            {role}
            <select value={chosen.value[role] ?? ""} onChange={(event) => set(role, event.currentTarget.value)}>
              <option value="">embedded</option>
              {known.backends
                .filter((b) => b.name !== "embedded" && b.roles.includes(role))
                .map((b) => (
                  <option key={b.name} value={b.name} disabled={!b.available}>
                    {b.name}
                    {b.available ? "" : " (missing)"}
                  </option>
                ))}
            </select>
          </label>
        ))}
        {known.backends.some((b) => !b.available) && (
          <p class="small quiet">
            Missing:{" "}
            {known.backends
              .filter((b) => !b.available)
              .map((b) => `${b.name} (${b.lacks})`)
              .join(", ")}
          </p>
        )}
        <label>
          Cost limit
          <input type="number" min="0" step="0.01" placeholder={charges(chosen.value) ? "no limit" : "free"} value={budget.value} onInput={(event) => (budget.value = event.currentTarget.value)} />
        </label>
      </div>
    </details>
  );
}

function Costs({ estimate, tables }: { estimate: EstimateRow; tables: number }) {
  return (
    <div role="status" class="stack small">
      {estimate.asks_servers ? (
        <>
          <p>The first requests{tables > 1 ? ` for each of ${tables} tables` : ""} would be:</p>
          <ul>
            {estimate.calls.map((line, k) => (
              <li key={k}>{line}</li>
            ))}
          </ul>
          <p class="quiet">Nothing was sent; later requests depend on the answers.</p>
        </>
      ) : (
        <p>No requests to servers: this is free.</p>
      )}
    </div>
  );
}
