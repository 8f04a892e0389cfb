/** How long the page is seen, counted once however many of its tabs are seen at a time. */
import type { Study } from "./study";

const TICK = 5; // seconds between the clock's notes
const LONGEST = 30; // seconds that one note may add: a machine may have slept

/** The stretch of time that was counted last, by whichever tab; milliseconds since 1970. */
interface Stretch {
  from: number;
  to: number;
}

const key = (study: Study): string => `study-${study.study}-clock`;

/** Calls `add` with seconds for which the page was seen; returns what has it called at once. */
export function watchTime(study: Study, add: (seconds: number) => void): () => void {
  let since = performance.now();
  const tick = (): void => {
    const now = performance.now();
    const passed = Math.min(now - since, LONGEST * 1000);
    since = now;
    add(countOnce(study, passed) / 1000);
  };
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) tick();
    else since = performance.now();
  });
  window.addEventListener("pagehide", () => {
    if (!document.hidden) tick();
  });
  setInterval(() => {
    if (!document.hidden) tick();
  }, TICK * 1000);
  return tick;
}

/** Returns what of the milliseconds that just passed no tab has counted, and counts it. */
function countOnce(study: Study, passed: number): number {
  const to = Date.now();
  const from = to - passed;
  const before = read(study, to);
  const common = before ? Math.min(to, before.to) - Math.max(from, before.from) : -1;
  // Tabs that are seen at a time count in turn, so that their stretches become one.
  const counted = before && common >= 0 ? { from: Math.min(from, before.from), to } : { from, to };
  try {
    localStorage.setItem(key(study), JSON.stringify(counted));
  } catch {
    return passed; // nothing is kept, so that tabs share nothing
  }
  return passed - Math.max(common, 0);
}

/** Returns the stretch counted last; null if there is none before now, by the clock as it is set. */
function read(study: Study, now: number): Stretch | null {
  try {
    const { from, to } = JSON.parse(localStorage.getItem(key(study)) ?? "{}") as Partial<Stretch>;
    if (typeof from !== "number" || typeof to !== "number" || from > to || to > now) return null;
    return { from, to };
  } catch {
    return null;
  }
}
