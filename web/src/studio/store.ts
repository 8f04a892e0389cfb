/** What the page knows of the studio: jobs as events tell of them, scenes, and the last message. */
import { computed, signal } from "@preact/signals";
import { api, listen, type JobEvent, type JobRequest, type JobRow, type StudioScene, type StudioState } from "./api";

export const studio = signal<StudioState | null>(null);
export const jobs = signal<ReadonlyMap<string, JobRow>>(new Map());
export const scenes = signal<StudioScene[]>([]);
export const scenesRead = signal(false);
export const connected = signal(true);

export interface Message {
  text: string;
  bad: boolean;
  /** What can be done about it. */
  remedy?: { label: string; run: () => void } | undefined;
}

export const message = signal<Message | null>(null);

export const jobList = computed(() => [...jobs.value.values()].sort((a, b) => b.created - a.created));

export const isOver = (job: JobRow): boolean => ["done", "failed", "cancelled"].includes(job.state);

export function tell(text: string, bad = false, remedy?: Message["remedy"]): void {
  message.value = { text, bad, remedy };
}

/** Runs what may fail; the failure is told on the page. Returns what it gives, undefined if it failed. */
export async function attempt<T>(work: () => Promise<T>): Promise<T | undefined> {
  try {
    return await work();
  } catch (error) {
    tell(error instanceof Error ? error.message : String(error), true);
    return undefined;
  }
}

function put(job: JobRow): void {
  jobs.value = new Map(jobs.value).set(job.id, job);
}

export async function refreshScenes(): Promise<void> {
  await attempt(async () => {
    scenes.value = await api.scenes();
    scenesRead.value = true;
  });
}

async function refreshJob(id: string): Promise<void> {
  try {
    put(await api.job(id));
  } catch {
    // it was removed in the meantime
  }
}

/** Begins a job; resolves to it, or to undefined where it was refused. */
export async function begin(request: JobRequest): Promise<JobRow | undefined> {
  const job = await attempt(() => api.begin(request));
  if (job) put(job);
  return job;
}

/** Resolves once a job is over. */
export function whenOver(id: string): Promise<JobRow> {
  return new Promise((resolve) => {
    const stop = jobs.subscribe((known) => {
      const job = known.get(id);
      if (!job || !isOver(job)) return;
      queueMicrotask(() => stop());
      resolve(job);
    });
  });
}

function heed(event: JobEvent): void {
  const job = jobs.value.get(event.job);
  if (event.type === "state" && event.state === "deleted") {
    const rest = new Map(jobs.value);
    rest.delete(event.job);
    jobs.value = rest;
    return;
  }
  if (!job || event.type === "state" || event.type === "result") {
    void refreshJob(event.job).then(() => {
      if (event.type === "result" && event.scene) void refreshScenes();
    });
    return;
  }
  if (event.type === "stage") put({ ...job, stage: { name: event.name, number: event.number, total: event.total } });
  if (event.type === "figure" && !job.figures.some((f) => f.url === event.url)) {
    put({ ...job, figures: [...job.figures, { name: event.name, stage: event.stage, url: event.url }] });
  }
  if (event.type === "log") put({ ...job, log: (job.log + event.text).slice(-20000) });
}

/** Reads everything once, then follows what happens. */
export async function connect(): Promise<void> {
  await attempt(async () => {
    studio.value = await api.state();
    jobs.value = new Map((await api.jobs()).map((job) => [job.id, job]));
    await refreshScenes();
    listen(studio.value.last_event, heed, (is) => (connected.value = is));
  });
}
