/** One job: its stages with their pictures as they arrive, and its result. */
import { useEffect } from "preact/hooks";
import { addressOf, useTitle } from "../ui/routing";
import { api, type FigureRow } from "./api";
import { Controls, Progress } from "./jobs";
import { isOver, jobs, refreshJob, studio } from "./store";

/** "fig08_reference.png" is "reference". */
const captionOf = ({ name }: FigureRow): string => name.replace(/\.png$/, "").replace(/^fig\d+_/, "").replaceAll("_", " ");

export function JobPage({ id }: { id: string }) {
  const job = jobs.value.get(id);
  const made = job?.state === "done" ? job.result?.scene : null;
  useTitle(job ? `${job.title} – TabletopGen studio` : "TabletopGen studio");
  useEffect(() => void refreshJob(id), [id]); // lists have no logs
  if (!job) return <p class="quiet">{studio.value ? "This job does not exist. It may have been removed." : "Loading the jobs …"}</p>;
  const stages = [...new Set(job.figures.map((figure) => figure.stage))];
  if (!isOver(job)) stages.reverse(); // show new stages without scrolling
  return (
    <div class="stack">
      <h1>{job.title}</h1>
      <div role="status">
        <Progress job={job} />
      </div>
      <div class="row">
        {made && (
          <a class="button primary" href={addressOf("scene", made)}>
            Open the table
          </a>
        )}
        <Controls job={job} />
      </div>
      {job.request.kind === "generate" && job.request.picture && (
        <img class="thumb" alt="The input picture" src={api.picture(job.request.picture)} />
      )}
      {stages.map((stage) => (
        <section key={stage} class="panel">
          <h2>{stage}</h2>
          <div class="figures">
            {job.figures
              .filter((figure) => figure.stage === stage)
              .map((figure) => (
                <figure key={figure.url}>
                  <a href={figure.url} target="_blank" rel="noreferrer">
                    <img src={figure.url} alt={`${captionOf(figure)} of the stage ${stage}`} />
                  </a>
                  {captionOf(figure) !== stage && <figcaption class="small quiet">{captionOf(figure)}</figcaption>}
                </figure>
              ))}
          </div>
        </section>
      ))}
      {job.log && (
        <details class="panel">
          <summary>Log</summary>
          <pre tabIndex={0}>{job.log}</pre>
        </details>
      )}
    </div>
  );
}
