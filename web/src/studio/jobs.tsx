/** Jobs: what runs, what waits, what was made. */
import { addressOf } from "../ui/routing";
import { api, type JobRow } from "./api";
import { attempt, isOver, jobList } from "./store";

export const link = (job: JobRow): string => (job.result?.scene && job.kind !== "episode" && job.kind !== "export" ? addressOf("scene", job.result.scene) : `#/job/${job.id}`);

export function JobsPanel() {
  const shown = jobList.value.slice(0, 20);
  return (
    <section class="panel" aria-label="Jobs">
      <h2>Jobs</h2>
      {shown.length === 0 && <p class="quiet small">Nothing was asked for yet.</p>}
      <ul class="plain stack">
        {shown.map((job) => (
          <li key={job.id} class="stack job">
            <a href={link(job)}>{job.title}</a>
            <Progress job={job} />
            <Controls job={job} />
          </li>
        ))}
      </ul>
    </section>
  );
}

export function Progress({ job }: { job: JobRow }) {
  const words = job.state === "running" && job.stage ? `${job.stage.name} (${job.stage.number} of ${job.stage.total})` : job.state;
  return (
    <div class="stack tight">
      <span class={`small ${job.state === "failed" ? "bad" : job.state === "done" ? "good" : "quiet"}`}>
        {job.kind}: {words}
      </span>
      {job.state === "running" && (
        <progress aria-label={`Progress of ${job.title}`} max={job.stage?.total ?? 1} value={job.stage ? job.stage.number - 0.5 : undefined} />
      )}
      {job.error && <span class="small bad">{job.error}</span>}
    </div>
  );
}

export function Controls({ job }: { job: JobRow }) {
  const done = job.state === "done";
  return (
    <div class="row">
      {!isOver(job) && (
        <button class="slim" onClick={() => void attempt(() => api.cancel(job.id))}>
          Cancel
        </button>
      )}
      {isOver(job) && !done && (
        <button class="slim" onClick={() => void attempt(() => api.resume(job.id))}>
          Resume
        </button>
      )}
      {isOver(job) && (
        <button class="slim" aria-label={`Remove the job ${job.title} from the list`} onClick={() => void attempt(() => api.remove(job.id))}>
          Remove
        </button>
      )}
      {done && job.kind === "generate" && <a href={`#/job/${job.id}`}>Stages</a>}
      {done && job.result?.url && (
        <a href={job.result.url} download={job.result.file ?? ""}>
          {job.result.file}
        </a>
      )}
    </div>
  );
}
