/** The page's state: jobs, updated by events, scenes, and the last message. */
import { computed, signal } from "@preact/signals";
import { api, StudioError, type JobEvent, type JobRequest, type JobRow, type StudioScene, type StudioState } from "./api";
import { listen } from "./events";

export const studio = signal<StudioState | null>(null);
export const jobs = signal<ReadonlyMap<string, JobRow>>(new Map());
export const scenes = signal<StudioScene[]>([]);
export const scenesRead = signal(false);
export const connected = signal(true);

export interface Message {
  text: string;
  bad: boolean;
  /** The address of the page to which it belongs. */
  at: string;
  /** A possible remedy. */
  remedy?: { label: string; run: () => void } | undefined;
}

export const message = signal<Message | null>(null);

export const jobList = computed(() => [...jobs.value.values()].sort((a, b) => b.created - a.created));

/** The waiting or running edit of the scene, whoever started it. */
export const editUnderWay = (id: string): JobRow | undefined =>
  jobList.value.find((job) => job.request.kind === "edit" && job.request.scene === id && !isOver(job));

/** Whether a job is finished; an interrupted one restarts automatically unless it has an error. */
export const isOver = (job: JobRow): boolean =>
  ["done", "failed", "cancelled"].includes(job.state) || (job.state === "interrupted" && job.error !== null);

export function tell(text: string, bad = false, remedy?: Message["remedy"]): void {
  message.value = { text, bad, remedy, at: location.hash };
}

/** Runs an action that may fail, and shows an error on the page. Returns its result, undefined after an error. */
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

function drop(id: string): void {
  const rest = new Map(jobs.value);
  rest.delete(id);
  jobs.value = rest;
}

/** Pending reads of jobs, and the jobs with newer events since their read began. */
const reading = new Map<string, Promise<void>>();
const changed = new Set<string>();

/** Reads a job; reads of the same job are serialised, so that the latest result is kept. */
export function refreshJob(id: string): Promise<void> {
  changed.add(id);
  const begun = reading.get(id) ?? readJob(id);
  reading.set(id, begun);
  return begun;
}

async function readJob(id: string): Promise<void> {
  while (changed.delete(id)) {
    try {
      put(await api.job(id));
    } catch (error) {
      if (error instanceof StudioError && error.status === 404) drop(id);
    }
  }
  reading.delete(id);
}

/** Starts a job; resolves to it, or to undefined if it was rejected. */
export async function begin(request: JobRequest): Promise<JobRow | undefined> {
  message.value = null; // it was about an earlier action
  const job = await attempt(() => api.begin(request));
  if (job && !jobs.value.has(job.id)) put(job); // otherwise events have already updated it
  return job;
}

/** Resolves when a job is finished; to undefined if it was removed. */
export function whenOver(id: string): Promise<JobRow | undefined> {
  return new Promise((resolve) => {
    const stop = jobs.subscribe((known) => {
      const job = known.get(id);
      if (job && !isOver(job)) return;
      queueMicrotask(() => stop());
      resolve(job);
    });
  });
}

async function heed(event: JobEvent): Promise<void> {
  if (event.type === "state" && event.state === "deleted") drop(event.job); // also drop a concurrent read
  await refreshJob(event.job);
  if (event.type === "result" && event.scene) await refreshScenes();
}

/** Reads the parts that could not be read while the studio was unreachable. */
function hear(is: boolean): void {
  if (is && !connected.value) for (const job of jobList.value) if (!isOver(job)) void refreshJob(job.id);
  connected.value = is;
}

/** Milliseconds between attempts to reach the studio at the start. */
const AGAIN = 2000;

/** Reads everything once, then follows events; retries until that succeeds. */
export async function connect(): Promise<void> {
  const begun = await attempt(async () => {
    const state = await api.state();
    jobs.value = new Map((await api.jobs()).map((job) => [job.id, job]));
    studio.value = state;
    await refreshScenes();
    listen(state.last_event, (event) => void heed(event), hear);
    return true;
  });
  if (!begun) {
    setTimeout(() => void connect(), AGAIN);
    return;
  }
  // Other pages save and remove scenes, for which there are no events.
  window.addEventListener("focus", () => void refreshScenes());
}
