/** The data of a study that `tabletopgen study new` inserts into the page. */

export interface Result {
  id: string;
  views: string[];
}

export interface Scene {
  id: string;
  input: string;
  /** One result per method; the k-th result of every scene is from the same method. */
  results: Result[];
}

export interface Study {
  study: string;
  title: string;
  scenesEach: number;
  attention: number;
  /** The path on the page's own server that accepts answers, if any. */
  post: string | null;
  scenes: Scene[];
}

export const QUESTIONS = [
  "visual_fidelity",
  "image_alignment",
  "physical_plausibility",
  "overall",
] as const;

export type Question = (typeof QUESTIONS)[number];

export const LEVELS = [1, 2, 3, 4, 5, 6, 7] as const;

export const isLevel = (value: unknown): value is number =>
  typeof value === "number" && (LEVELS as readonly number[]).includes(value);

/** Returns the study of this page; null if the page was built without one. */
export function readStudy(): Study | null {
  const data = document.getElementById("study")?.textContent ?? "null";
  return JSON.parse(data) as Study | null;
}
