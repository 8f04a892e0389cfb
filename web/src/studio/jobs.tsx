/** Jobs: running, waiting and finished. */
import { addressOf } from "../ui/routing";
import { api, type JobRow } from "./api";
import { attempt, isOver, jobList } from "./store";

/** Maximum number of jobs in each list. */
const MOST = 20;

export const link = (job: JobRow): string => (job.result?.scene && job.kind !== "episode" && job.kind !== "export" ? addressOf("scene", job.result.scene) : `#/job/${job.id}`);

/** Whether a finished job belongs only to the page of its scene. */
const isAside = (job: JobRow): boolean => isOver(job) && job.kind !== "generate" && job.kind !== "compose";

export function JobsPanel() {
  const shown = jobList.value.filter((job) => !isAside(job)).slice(0, MOST);
  const aside = jobList.value.filter(isAside).slice(0, MOST);
  return (
    <section class="panel" aria-label="Jobs">
      <h2>Jobs</h2>
      {shown.length === 0 && <p class="quiet small">No table is being made.</p>}
      <List jobs={shown} />
      {aside.length > 0 && (
        <details>
          <summary>Edits, exports and episodes ({aside.length})</summary>
          <List jobs={aside} />
        </details>
      )}
    </section>
  );
}

function List({ jobs }: { jobs: JobRow[] }) {
  return (
    <ul class="plain stack jobs" tabIndex={0}>
      {jobs.map((job) => (
        <li key={job.id} class="stack job">
          <a href={link(job)}>{job.title}</a>
          <Progress job={job} />
          <Controls job={job} />
        </li>
      ))}
    </ul>
  );
}

export function Progress({ job }: { job: JobRow }) {
  const { seed } = job.request as { seed?: number };
  const words = job.state === "running" && job.stage ? `${job.stage.name} (${job.stage.number} of ${job.stage.total})` : job.state;
  return (
    <div class="stack tight">
      <span class={`small ${job.state === "failed" ? "bad" : job.state === "done" ? "good" : "quiet"}`}>
        {job.kind}
        {seed ? `, seed ${seed}` : ""}: {words}
      </span>
      {job.state === "running" && (
        <progress aria-label={`Progress of ${job.title}`} max={job.stage?.total ?? 1} value={job.stage ? job.stage.number - 0.5 : undefined} />
      )}
      {job.error && <span class="small bad">{job.error}</span>}
    </div>
  );
}

/** Label of the button that restarts a job; null if it would fail again. */
function againOf(job: JobRow): string | null {
  if (job.state === "failed") return job.kind === "edit" ? null : "Try again";
  return job.state === "done" ? null : "Start again";
}

export function Controls({ job }: { job: JobRow }) {
  const over = isOver(job);
  const again = over ? againOf(job) : null;
  return (
    <div class="row">
      {!over && (
        <button class="slim" onClick={() => void attempt(() => api.cancel(job.id))}>
          Cancel
        </button>
      )}
      {again && (
        <button class="slim" onClick={() => void attempt(() => api.resume(job.id))}>
          {again}
        </button>
      )}
      {over && (
        <button class="slim" aria-label={`Remove the job ${job.title} from the list`} onClick={() => void attempt(() => api.remove(job.id))}>
          Remove
        </button>
      )}
      {job.state === "done" && job.kind === "generate" && <a href={`#/job/${job.id}`}>Stages</a>}
      {job.state === "done" && job.result?.url && (
        <a href={job.result.url} download={job.result.file ?? ""}>
          {job.result.file}
        </a>
      )}
    </div>
  );
}
