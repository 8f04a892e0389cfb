/** The studio's server: what it answers, and how it is asked. */
import { PageError, type SceneRow } from "../data";

export type JobKind = "generate" | "compose" | "edit" | "episode" | "export";
export type JobState = "queued" | "running" | "done" | "failed" | "cancelled" | "interrupted";
export type EditAction = "swap" | "add" | "remove" | "move" | "restyle";

export interface StageRow {
  name: string;
  number: number;
  total: number;
}

export interface FigureRow {
  name: string;
  stage: string;
  url: string;
}

export interface JobResult {
  scene: string | null;
  file: string | null;
  url: string | null;
  bytes: number | null;
  facts: Record<string, unknown>;
}

export interface JobRow {
  id: string;
  kind: JobKind;
  state: JobState;
  title: string;
  request: Record<string, unknown>;
  created: number;
  started: number | null;
  finished: number | null;
  runs: number;
  stage: StageRow | null;
  figures: FigureRow[];
  error: string | null;
  result: JobResult | null;
  log: string;
}

export type JobEvent = { seq: number; job: string; time: number } & (
  | { type: "state"; state: JobState | "deleted"; error?: string | null }
  | ({ type: "stage" } & StageRow)
  | ({ type: "figure" } & FigureRow)
  | { type: "log"; text: string }
  | ({ type: "result" } & JobResult)
);

/** A scene that the studio knows: what a gallery shows of it, where it lies, what it came from. */
export interface StudioScene extends SceneRow {
  in: "workspace" | "store" | "shipped";
  digest: string;
  editable: boolean;
  parent: string | null;
}

export interface EditRow {
  id: string;
  digest: string;
  kind: string;
  asked: string;
  names: string[];
  exists: boolean;
}

/** The steps that led to a scene, it being the last, and the ids of those edited from it. */
export interface HistoryRow {
  scene: string;
  steps: EditRow[];
  later: string[];
}

export interface BackendRow {
  name: string;
  roles: string[];
  needs: string;
  lacks: string;
  charges: boolean;
  available: boolean;
}

export interface StudioState {
  version: string;
  roles: string[];
  backends: BackendRow[];
  formats: string[];
  tasks: string[];
  store: string;
  folder: string;
  workers: number;
  queue_limit: number;
  last_event: number;
}

export interface ExplainedRow {
  role: string;
  phrase: string;
  meaning: string;
}

export interface EstimateRow {
  roles: { role: string; backend: string; settings: Record<string, unknown> }[];
  calls: string[];
  asks_servers: boolean;
}

export interface PictureRow {
  picture: string;
  width: number;
  height: number;
}

/** What a job asks for; the server checks every field. */
export type JobRequest = { kind: JobKind } & Record<string, unknown>;

async function ask<T>(method: string, path: string, body?: BodyInit, type?: string): Promise<T> {
  let response: Response;
  try {
    response = await fetch(path, {
      method,
      credentials: "same-origin",
      ...(body === undefined ? {} : { body, headers: { "Content-Type": type ?? "application/json" } }),
    });
  } catch {
    throw new PageError("The studio does not answer. Is it still running?");
  }
  if (response.status === 204) return undefined as T;
  const text = await response.text();
  let value: unknown = null;
  try {
    value = JSON.parse(text);
  } catch {
    // an answer that is no JSON is told by its text
  }
  if (!response.ok) {
    const told = (value as { error?: unknown } | null)?.error;
    throw new PageError(typeof told === "string" ? told : text.slice(0, 300) || `The studio says ${response.status}.`);
  }
  return value as T;
}

const get = <T>(path: string): Promise<T> => ask<T>("GET", path);
const post = <T>(path: string, value: unknown = {}): Promise<T> => ask<T>("POST", path, JSON.stringify(value));
const name = encodeURIComponent;

export const api = {
  state: () => get<StudioState>("/api/state"),
  jobs: async () => (await get<{ jobs: JobRow[] }>("/api/jobs")).jobs,
  job: (id: string) => get<JobRow>(`/api/jobs/${name(id)}`),
  begin: (job: JobRequest) => post<JobRow>("/api/jobs", job),
  cancel: (id: string) => post<JobRow>(`/api/jobs/${name(id)}/cancel`),
  resume: (id: string) => post<JobRow>(`/api/jobs/${name(id)}/resume`),
  remove: (id: string) => ask<void>("DELETE", `/api/jobs/${name(id)}`),
  explain: async (text: string) => (await post<{ rows: ExplainedRow[] }>("/api/explain", { text })).rows,
  estimate: (job: JobRequest) => post<EstimateRow>("/api/estimate", job),
  upload: (file: Blob) => ask<PictureRow>("POST", "/api/pictures", file, "application/octet-stream"),
  scenes: async () => (await get<{ scenes: StudioScene[] }>("/api/scenes")).scenes,
  history: (id: string) => get<HistoryRow>(`/api/scenes/${name(id)}/history`),
  save: (id: string) => post<{ path?: string }>(`/api/scenes/${name(id)}/save`),
  discard: (id: string) => ask<void>("DELETE", `/api/scenes/${name(id)}`),
  /** The folder of a scene, as the viewer opens it. */
  folder: (id: string) => `/api/scenes/${name(id)}/`,
  picture: (id: string) => `/api/pictures/${name(id)}`,
};
