/** Client of the studio's server. The types correspond to `studio/contracts.py`. */
import { PageError, type SceneRow } from "../data";

export type JobKind = "generate" | "compose" | "edit" | "episode" | "export";
export type JobState = "queued" | "running" | "done" | "failed" | "cancelled" | "interrupted";
export type ScenePlace = "workspace" | "store" | "shipped";
export type Role = "reasoner" | "imager" | "segmenter" | "modeler" | "encoder";
export type Format = "glb" | "mjcf" | "sdf" | "urdf" | "usd" | "usdz";

/** Backends of a job by role, and its cost limit (none if omitted). */
export type Paid = { backend?: string; budget?: number } & Partial<Record<Role, string>>;

/** A scene from a text or an uploaded picture, by the full method. */
export interface GenerateRequest extends Paid {
  kind: "generate";
  text?: string;
  picture?: string;
  seed?: number;
  name?: string;
}

/** A scene from a text, composed directly of catalogue objects. */
export interface ComposeRequest {
  kind: "compose";
  text: string;
  seed?: number;
  density?: "sparse" | "normal" | "dense";
  name?: string;
}

/**
 * An edit of a scene. `words`: swap [name, what], add [what and where], remove [name], move [name,
 * where] or [name] with `to` (metres from the table's middle) or `turn` (degrees), restyle [style,
 * names...]. New objects come from the catalogue unless a backend or role is given.
 */
export interface EditRequest extends Paid {
  kind: "edit";
  scene: string;
  action: "swap" | "add" | "remove" | "move" | "restyle";
  words: string[];
  to?: [number, number];
  turn?: number;
  seed?: number;
}

/** An episode of a task at a scene, played by the scripted expert. */
export interface EpisodeRequest {
  kind: "episode";
  scene: string;
  task: string;
  seed?: number;
}

/** A scene in the format of another program. */
export interface ExportRequest {
  kind: "export";
  scene: string;
  format: Format;
}

export type JobRequest =
  | GenerateRequest
  | ComposeRequest
  | EditRequest
  | EpisodeRequest
  | ExportRequest;

/** The current stage of a job, with its number from 1. */
export interface StageRow {
  name: string;
  number: number;
  total: number;
}

/** A picture of a stage's result. */
export interface FigureRow {
  name: string;
  stage: string;
  url: string;
}

/** Result of a job: a scene of the workspace, or a file to fetch from `url`; of a failed one, facts about its error. */
export interface JobResult {
  scene: string | null;
  file: string | null;
  url: string | null;
  bytes: number | null;
  facts: Record<string, unknown>;
}

/** A job; times are seconds since 1970. `log` is empty in lists. */
export interface JobRow {
  id: string;
  kind: JobKind;
  state: JobState;
  title: string;
  request: JobRequest;
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

interface Happened {
  seq: number;
  job: string;
  time: number;
}

/** An event of a job. A removed job has the state "deleted". */
export type JobEvent = Happened &
  (
    | { type: "state"; state: JobState | "deleted"; error?: string }
    | ({ type: "stage" } & StageRow)
    | ({ type: "figure" } & FigureRow)
    | { type: "log"; text: string }
    | ({ type: "result" } & JobResult)
  );

/** A scene of the list: its gallery entry, its location, and its edits. */
export interface StudioScene extends SceneRow {
  in: ScenePlace;
  digest: string;
  editable: boolean;
  parent: string | null;
  /** Whether the user's store also has it. */
  saved: boolean;
  edits: number;
  /** Description of the last edit. */
  last_edit: string;
}

/** A step of a scene's history: the resulting scene. `kind` is "made" for the original one. */
export interface EditRow {
  id: string;
  digest: string;
  kind: string;
  asked: string;
  names: string[];
  exists: boolean;
}

/** The steps that led to a scene, including it, and the scenes edited from it. */
export interface SceneHistory {
  scene: string;
  steps: EditRow[];
  later: string[];
}

export interface PictureRow {
  picture: string;
  width: number;
  height: number;
}

export interface ExplainedRow {
  role: string;
  phrase: string;
  meaning: string;
}

/** The interpretation of a text: a summary of table and objects, and each phrase. */
export interface Explanation {
  summary: string;
  rows: ExplainedRow[];
}

export interface RoleRow {
  role: string;
  backend: string;
  settings: Record<string, unknown>;
}

/** The first requests of a job to servers, a line each, and their maximum cost. */
export interface EstimateRow {
  roles: RoleRow[];
  calls: string[];
  asks_servers: boolean;
}

export interface BackendRow {
  name: string;
  roles: Role[];
  needs: string;
  lacks: string;
  charges: boolean;
  available: boolean;
}

export interface StudioState {
  version: string;
  roles: Role[];
  backends: BackendRow[];
  formats: Format[];
  tasks: string[];
  store: string;
  folder: string;
  workers: number;
  queue_limit: number;
  last_event: number;
}

/** An error of the server: `status` of its response (0: unreachable), and its message. */
export class StudioError extends PageError {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
    this.name = "StudioError";
  }
}

async function refusal(answer: Response): Promise<StudioError> {
  const said: unknown = await answer.json().catch(() => null);
  const known = typeof said === "object" && said !== null && "error" in said;
  const message = known ? String(said.error) : `The studio responded with status ${answer.status}.`;
  return new StudioError(answer.status, message);
}

async function ask<T>(method: string, path: string, body?: object | Blob): Promise<T> {
  const init: RequestInit = { method };
  if (body instanceof Blob) init.body = body;
  else if (body !== undefined) {
    init.body = JSON.stringify(body);
    init.headers = { "content-type": "application/json" };
  }
  const answer = await fetch(path, init).catch(() => {
    throw new StudioError(0, "The studio is not reachable. Is it still running?");
  });
  if (!answer.ok) throw await refusal(answer);
  return (answer.status === 204 ? undefined : await answer.json()) as T;
}

/** Maximum size of an uploaded picture, bytes; `MOST_BYTES` of `studio/library/pictures.py`. */
const MOST_PICTURE = 20 * 2 ** 20;

const job = (id: string): string => `/api/jobs/${encodeURIComponent(id)}`;
const scene = (id: string): string => `/api/scenes/${encodeURIComponent(id)}`;

/** All endpoints; each rejects with a `StudioError`. */
export const api = {
  state: () => ask<StudioState>("GET", "/api/state"),
  jobs: async () => (await ask<{ jobs: JobRow[] }>("GET", "/api/jobs")).jobs,
  job: (id: string) => ask<JobRow>("GET", job(id)),
  begin: (request: JobRequest) => ask<JobRow>("POST", "/api/jobs", request),
  cancel: (id: string) => ask<JobRow>("POST", `${job(id)}/cancel`),
  resume: (id: string) => ask<JobRow>("POST", `${job(id)}/resume`),
  remove: (id: string) => ask<void>("DELETE", job(id)),
  upload: async (picture: Blob) => {
    // Browsers ignore the response of a server that rejects a request during its upload.
    if (picture.size > MOST_PICTURE) throw new StudioError(413, "The picture exceeds the limit of 20 MiB.");
    return ask<PictureRow>("POST", "/api/pictures", picture);
  },
  picture: (id: string) => `/api/pictures/${encodeURIComponent(id)}`,
  explain: (text: string, seed = 0) => ask<Explanation>("POST", "/api/explain", { text, seed }),
  estimate: (request: JobRequest) => ask<EstimateRow>("POST", "/api/estimate", request),
  scenes: async () => (await ask<{ scenes: StudioScene[] }>("GET", "/api/scenes")).scenes,
  /** The folder of a scene for the viewer. */
  folder: (id: string) => `${scene(id)}/`,
  history: (id: string) => ask<SceneHistory>("GET", `${scene(id)}/history`),
  save: (id: string) => ask<StudioScene>("POST", `${scene(id)}/save`, {}),
  discard: (id: string) => ask<void>("DELETE", scene(id)),
};
