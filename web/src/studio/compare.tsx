/** Scenes side by side: seeds of one text, variants of one table. */
import { Viewer } from "../viewer/viewer";
import { addressOf, useTitle } from "../ui/routing";
import { api } from "./api";
import { Edits } from "./scenes";
import { scenes, scenesRead } from "./store";

export function ComparePage({ ids }: { ids: string[] }) {
  useTitle("Side by side – TabletopGen studio");
  const rows = ids.map((id) => scenes.value.find((row) => row.id === id));
  return (
    <>
      <h1>Side by side</h1>
      <div class="pair">
        {rows.map((row, k) =>
          row ? (
            <section key={row.id} class="stack" aria-label={row.name}>
              <h2>
                <a href={addressOf("scene", row.id)}>{row.name}</a>
              </h2>
              <p class="small quiet">
                {row.prompt}
                {row.seed !== null && ` (seed ${row.seed})`}
              </p>
              <Edits row={row} />
              <Viewer base={api.folder(row.id)} label={row.name} small />
            </section>
          ) : (
            <p key={ids[k]} class="quiet">
              {scenesRead.value ? `There is no scene ${ids[k]}.` : "Loading the scenes …"}
            </p>
          ),
        )}
      </div>
    </>
  );
}
