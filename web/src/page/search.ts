/** Filters and order of the scenes in a gallery. */
import type { SceneRow } from "../data";

export interface Filter {
  words: string;
  theme: string;
  difficulty: "" | "easy" | "medium" | "hard";
  certified: boolean;
}

export const NO_FILTER: Filter = { words: "", theme: "", difficulty: "", certified: false };

/** Bounds of "medium" on the scale of `tabletopgen_env.scenes.difficulty`. */
const EASY = 0.3;
const HARD = 0.45;

export function level(row: SceneRow): "easy" | "medium" | "hard" | "" {
  if (row.difficulty === null) return "";
  return row.difficulty < EASY ? "easy" : row.difficulty < HARD ? "medium" : "hard";
}

/** Whether the expert always solves every task of the scene. */
export function isCertified({ certificate }: SceneRow): boolean {
  return certificate !== null && certificate.certified > 0 && certificate.certified === certificate.instances;
}

/** The objects on a table, in words: "2 × mug, laptop". */
export function contents(row: SceneRow): string {
  const counts = new Map<string, number>();
  for (const { label } of row.things) counts.set(label, (counts.get(label) ?? 0) + 1);
  return [...counts].map(([label, n]) => (n > 1 ? `${n} × ${label}` : label)).join(", ");
}

export function themes(rows: SceneRow[]): string[] {
  return [...new Set(rows.map((row) => row.theme).filter(Boolean))].sort();
}

/** Returns whether a scene has all words, singular or plural, in its name, its text or its objects. */
export function holds(row: SceneRow, words: string): boolean {
  const text = [row.id, row.prompt, ...row.asked, row.theme, row.table.label, ...row.things.flatMap((t) => [t.label, t.category, t.name])]
    .join(" ")
    .toLowerCase();
  const forms = words.toLowerCase().split(/\s+/).filter(Boolean).map(formsOf);
  return forms.every((any) => any.some((form) => text.includes(form)));
}

/** Possible plural endings, and the singular endings that they replace: no "plan" from "planes". */
const ENDINGS: [RegExp, string][] = [
  [/(..)ies$/, "$1y"],
  [/ves$/, "f"],
  [/([sxz]|[cs]h|...o)es$/, "$1"],
  [/s$/, ""],
];

/** A word, and its possible singulars: "knives", "knif", "knive". */
function formsOf(word: string): string[] {
  return [word, ...ENDINGS.filter(([end]) => end.test(word) && word.length > 3).map(([end, by]) => word.replace(end, by))];
}

export function matches(row: SceneRow, filter: Filter): boolean {
  return (
    holds(row, filter.words) &&
    (!filter.theme || row.theme === filter.theme) &&
    (!filter.difficulty || level(row) === filter.difficulty) &&
    (!filter.certified || isCertified(row))
  );
}
