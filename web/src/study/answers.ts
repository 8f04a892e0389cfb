/** A rater's answers for submission. */
import type { Page } from "./assignment";
import type { Progress } from "./progress";
import type { Study } from "./study";

const round = (seconds: number): number => Math.round(seconds * 10) / 10;

/** Returns the answers as JSON: a random id, ratings and times; nothing about the rater. */
export function toText(study: Study, pages: Page[], progress: Progress): string {
  const times = pages.map(({ scene }) => progress.seconds[scene.id] ?? 0);
  const answers = {
    schema: 1,
    study: study.study,
    rater: progress.rater,
    language: progress.language,
    seconds: round(times.reduce((sum, time) => sum + time, 0)),
    scenes: pages.map(({ scene, results }, k) => ({
      scene: scene.id,
      seconds: round(times[k] ?? 0),
      order: results.map((result) => result.id),
      ratings: Object.fromEntries(results.map(({ id }) => [id, progress.marks[id]])),
      choice: progress.choices[scene.id],
    })),
    checks: pages.flatMap(({ scene, check }) =>
      check
        ? [{ scene: scene.id, asked: check.asked, given: progress.checks[scene.id] }]
        : [],
    ),
  };
  return `${JSON.stringify(answers, null, 1)}\n`;
}

export const fileName = (study: Study, progress: Progress): string =>
  `answers-${study.study}-${progress.rater}.json`;

/** Saves a text as a file with the browser. */
export function download(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** Returns the path for submitting answers; null if the page is not from a server, or it accepts none. */
export const postPath = (study: Study): string | null =>
  location.protocol.startsWith("http") ? study.post : null;

/** Sends answers to the page's own server; returns whether it accepted them. */
export async function post(path: string, text: string): Promise<boolean> {
  try {
    const answer = await fetch(path, {
      method: "POST",
      body: text,
      headers: { "Content-Type": "application/json" },
      credentials: "same-origin",
      redirect: "error",
      signal: AbortSignal.timeout(30_000),
    });
    return answer.ok;
  } catch {
    return false;
  }
}
