/** The content of a page's files (written by `tabletopgen_web.page`), and how to read them. */

/** The supported version of these files. */
export const SCHEMA = 1;

/** Maximum size of a file of a page; those of a scene are far smaller. */
const MOST_BYTES = 128 * 1024 * 1024;

export interface ThingRow {
  name: string;
  label: string;
  category: string;
  /** Extents along the object's own axes, metres. */
  size: [number, number, number];
  mass: number;
  on: string;
}

/** Results of the physical gate, in metres, radians and seconds; see docs/concepts/gate.md. */
export interface GateRow {
  passed: boolean;
  failures: string[];
  penetration: number;
  drift: number;
  tilt: number;
}

export interface CertificateRow {
  instances: number;
  certified: number;
  tasks: { task: string; instances: number; certified: number; rate: number }[];
}

/** Gallery entry of a scene. */
export interface SceneRow {
  id: string;
  name: string;
  kind: string;
  prompt: string;
  /** Requests of the edits. */
  asked: string[];
  theme: string;
  /** Seed of the scene; null if it is not recorded. */
  seed: number | null;
  table: { label: string; size: [number, number, number] };
  things: ThingRow[];
  /** Difficulty for manipulation, in [0, 1]; null if unknown. */
  difficulty: number | null;
  gate: GateRow | null;
  certificate: CertificateRow | null;
  warnings: string[];
  thumbnail: string | null;
  /** Reason why the scene cannot be shown; null if it can. */
  error: string | null;
}

export interface Gallery {
  schema: number;
  title: string;
  made: string;
  scenes: SceneRow[];
}

export interface ModelFiles {
  xml: string;
  /** Paths of the files in the XML, by the name there. */
  files: Record<string, string>;
  /** The keyframe at which it starts. */
  start: string;
}

export interface EpisodeRow {
  task: string;
  instruction: string;
  file: string;
  seconds: number;
  success: boolean;
}

export interface Download {
  label: string;
  file: string;
  bytes: number;
}

/** All files in a scene's folder, with paths relative to it. */
export interface SceneFiles {
  schema: number;
  row: SceneRow;
  scene: ModelFiles;
  arm: ModelFiles | null;
  picture: { file: string; width: number; height: number; kind: "reference" | "preview" } | null;
  episodes: EpisodeRow[];
  downloads: Download[];
}

/** A recorded episode: a row with qpos and the marker's position per control step. */
export interface Episode {
  hz: number;
  nq: number;
  frames: number;
  instruction: string;
  success: boolean;
  rows: Float32Array;
}

/** An error with a message for the viewer of the page. */
export class PageError extends Error {}

async function fetchAny(url: string): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, { credentials: "same-origin" });
  } catch {
    throw new PageError(`${nameOf(url)} could not be loaded. Is the server still running?`);
  }
  if (!response.ok) {
    throw new PageError(`${nameOf(url)} is missing (${response.status}). Create the page again.`);
  }
  const length = Number(response.headers.get("Content-Length") ?? 0);
  if (length > MOST_BYTES) throw new PageError(`${nameOf(url)} is too large to show.`);
  return response;
}

const nameOf = (url: string): string => decodeURIComponent(url.split(/[?#]/)[0]!.split("/").pop() ?? url);

export async function fetchBytes(url: string): Promise<Uint8Array> {
  return new Uint8Array(await (await fetchAny(url)).arrayBuffer());
}

export async function fetchText(url: string): Promise<string> {
  return (await fetchAny(url)).text();
}

/** Reads a JSON file with a schema number. */
export async function fetchData<T extends { schema: number }>(url: string): Promise<T> {
  let value: unknown;
  try {
    value = JSON.parse(await fetchText(url));
  } catch (error) {
    if (error instanceof PageError) throw error;
    throw new PageError(`${nameOf(url)} is damaged. Create the page again.`);
  }
  const schema = (value as { schema?: unknown } | null)?.schema;
  if (typeof schema !== "number") throw new PageError(`${nameOf(url)} is damaged. Create the page again.`);
  if (schema > SCHEMA) {
    throw new PageError(`${nameOf(url)} was made by a newer version of tabletopgen. Update this page.`);
  }
  return value as T;
}

/** Reads a recorded episode: the length of a JSON header, the header, and rows of 32-bit floats. */
export async function fetchEpisode(url: string): Promise<Episode> {
  const bytes = await fetchBytes(url);
  try {
    const view = new DataView(bytes.buffer);
    const length = view.getUint32(0, true);
    const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as Omit<Episode, "rows">;
    const rows = new Float32Array(bytes.slice(4 + length).buffer);
    if (rows.length !== header.frames * (header.nq + 3) || !(header.frames > 1)) throw new Error("rows");
    return { ...header, rows };
  } catch {
    throw new PageError(`${nameOf(url)} is damaged. Create the page again.`);
  }
}

/** Fetches a model and its files. */
export async function fetchModel(base: string, model: ModelFiles): Promise<[string, [string, Uint8Array][]]> {
  const names = Object.entries(model.files);
  const [xml, ...files] = await Promise.all([
    fetchText(base + model.xml),
    ...names.map(async ([name, file]): Promise<[string, Uint8Array]> => [name, await fetchBytes(base + file)]),
  ]);
  return [xml, files];
}
