/** The embedded planner's interpretation of a text while it is typed, including phrases that it ignores. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { api, type ExplainedRow, type Explanation } from "./api";

/** Milliseconds after the last key press before a text is read. */
const PAUSE = 400;

export function Understood({ text, seed }: { text: string; seed: number }) {
  const found = useSignal<Explanation | string | null>(null);
  useEffect(() => {
    let wanted = true;
    if (!text) found.value = null;
    const read = async (): Promise<void> => {
      const said = await api.explain(text, seed).catch((error: Error) => error.message);
      if (wanted) found.value = said;
    };
    const timer = text ? setTimeout(() => void read(), PAUSE) : 0;
    return () => {
      wanted = false;
      clearTimeout(timer);
    };
  }, [text, seed]);
  return (
    <div class="stack tight small" aria-live="polite">
      {typeof found.value === "string" && <p class="bad">{found.value}</p>}
      {found.value !== null && typeof found.value === "object" && <Read explanation={found.value} />}
    </div>
  );
}

function Read({ explanation: { summary, rows } }: { explanation: Explanation }) {
  const lost = rows.filter((row) => row.role === "not understood");
  const notes = rows.filter((row) => row.role === "note");
  return (
    <>
      <p>{summary}</p>
      {lost.length > 0 && <p class="bad">Not understood: {lost.map(quoted).join(", ")}</p>}
      {notes.map((row) => (
        <p key={row.meaning} class="quiet">
          {row.meaning}
        </p>
      ))}
      <details>
        <summary>Interpretation of each phrase</summary>
        <div class="scroll" tabIndex={0} role="region" aria-label="Interpretation of each phrase">
          <table>
            <tbody>
              {rows.map((row, k) => (
                <tr key={k}>
                  <th scope="row">{row.role}</th>
                  <td>{row.phrase && quoted(row)}</td>
                  <td>{row.meaning}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </details>
    </>
  );
}

const quoted = (row: ExplainedRow): string => `“${row.phrase}”`;
