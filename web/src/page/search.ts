/** Which scenes of a gallery are shown, and in which order. */
import type { SceneRow } from "../data";

export interface Filter {
  words: string;
  theme: string;
  difficulty: "" | "easy" | "medium" | "hard";
  certified: boolean;
}

export const NO_FILTER: Filter = { words: "", theme: "", difficulty: "", certified: false };

/** The ends of "medium", on the scale of `tabletopgen_env.scenes.difficulty`. */
const EASY = 0.3;
const HARD = 0.45;

export function level(row: SceneRow): "easy" | "medium" | "hard" | "" {
  if (row.difficulty === null) return "";
  return row.difficulty < EASY ? "easy" : row.difficulty < HARD ? "medium" : "hard";
}

/** What is on a table, in words: "2 × mug, laptop". */
export function contents(row: SceneRow): string {
  const counts = new Map<string, number>();
  for (const { label } of row.things) counts.set(label, (counts.get(label) ?? 0) + 1);
  return [...counts].map(([label, n]) => (n > 1 ? `${n} × ${label}` : label)).join(", ");
}

export function themes(rows: SceneRow[]): string[] {
  return [...new Set(rows.map((row) => row.theme).filter(Boolean))].sort();
}

export function matches(row: SceneRow, filter: Filter): boolean {
  const text = [row.name, row.prompt, row.theme, row.table.label, ...row.things.flatMap((t) => [t.label, t.category, t.name])]
    .join(" ")
    .toLowerCase();
  return (
    filter.words.toLowerCase().split(/\s+/).filter(Boolean).every((word) => text.includes(word)) &&
    (!filter.theme || row.theme === filter.theme) &&
    (!filter.difficulty || level(row) === filter.difficulty) &&
    (!filter.certified || (row.certificate?.certified ?? 0) > 0)
  );
}
