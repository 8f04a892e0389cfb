/** What a page's files hold (written by `tabletopgen_web.page`), and how they are read. */

/** The version of these files that this page reads. */
export const SCHEMA = 1;

/** No file of a page is larger; a scene's are far smaller. */
const MOST_BYTES = 128 * 1024 * 1024;

export interface ThingRow {
  name: string;
  label: string;
  category: string;
  /** Extent along the thing's own axes, metres. */
  size: [number, number, number];
  mass: number;
  on: string;
}

/** The figures of the physical gate, metres, radians and seconds; see docs/concepts/gate.md. */
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

/** What the gallery shows of a scene. */
export interface SceneRow {
  id: string;
  name: string;
  kind: string;
  prompt: string;
  /** What edits asked for. */
  asked: string[];
  theme: string;
  /** What it was drawn with; null where that is not recorded. */
  seed: number | null;
  table: { label: string; size: [number, number, number] };
  things: ThingRow[];
  /** How hard it is to work at, in [0, 1]; null where that is not known. */
  difficulty: number | null;
  gate: GateRow | null;
  certificate: CertificateRow | null;
  warnings: string[];
  thumbnail: string | null;
  /** Why the scene cannot be shown; null if it can. */
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
  /** Paths of the files that the XML names, by that name. */
  files: Record<string, string>;
  /** The keyframe that it starts from. */
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

/** All that a scene's folder holds, with paths relative to it. */
export interface SceneFiles {
  schema: number;
  row: SceneRow;
  scene: ModelFiles;
  arm: ModelFiles | null;
  picture: { file: string; width: number; height: number; kind: "reference" | "preview" } | null;
  episodes: EpisodeRow[];
  downloads: Download[];
}

/** A recorded episode: a row of qpos, and of the marker's place, for every control step. */
export interface Episode {
  hz: number;
  nq: number;
  frames: number;
  instruction: string;
  success: boolean;
  rows: Float32Array;
}

/** What went wrong, in words for who looks at the page. */
export class PageError extends Error {}

async function fetchAny(url: string): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, { credentials: "same-origin" });
  } catch {
    throw new PageError(`${nameOf(url)} could not be loaded. Is the server still running?`);
  }
  if (!response.ok) {
    throw new PageError(`${nameOf(url)} is missing (${response.status}). Make the page again.`);
  }
  const length = Number(response.headers.get("Content-Length") ?? 0);
  if (length > MOST_BYTES) throw new PageError(`${nameOf(url)} is too large to be shown here.`);
  return response;
}

const nameOf = (url: string): string => decodeURIComponent(url.split(/[?#]/)[0]!.split("/").pop() ?? url);

export async function fetchBytes(url: string): Promise<Uint8Array> {
  return new Uint8Array(await (await fetchAny(url)).arrayBuffer());
}

export async function fetchText(url: string): Promise<string> {
  return (await fetchAny(url)).text();
}

/** Reads a JSON file that says its schema. */
export async function fetchData<T extends { schema: number }>(url: string): Promise<T> {
  let value: unknown;
  try {
    value = JSON.parse(await fetchText(url));
  } catch (error) {
    if (error instanceof PageError) throw error;
    throw new PageError(`${nameOf(url)} is damaged. Make the page again.`);
  }
  const schema = (value as { schema?: unknown } | null)?.schema;
  if (typeof schema !== "number") throw new PageError(`${nameOf(url)} is damaged. Make the page again.`);
  if (schema > SCHEMA) {
    throw new PageError(`${nameOf(url)} was made by a newer version of tabletopgen. Update this page.`);
  }
  return value as T;
}

/** Reads a recorded episode: the length of a JSON header, the header, rows of 32-bit floats. */
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
    throw new PageError(`${nameOf(url)} is damaged. Make the page again.`);
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
