/** How long the page is seen, counted once however many of its tabs are seen at a time. */

const TICK = 5; // seconds between the clock's notes
const LONGEST = 30; // seconds that one note may add: a machine may have slept

/** A stretch of time; milliseconds since 1970. */
export interface Stretch {
  from: number;
  to: number;
}

/** Calls `add` with the time for which the page was seen; returns what has it called at once. */
export function watchTime(add: (seen: Stretch) => void): () => void {
  let since = performance.now();
  const tick = (): void => {
    const now = performance.now();
    const passed = Math.min(now - since, LONGEST * 1000);
    since = now;
    const to = Date.now();
    add({ from: to - passed, to });
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

/**
 * Returns the seconds of `seen` that are not in `counted`, and what is counted then.
 *
 * Tabs that are seen at a time count in turn, so that their stretches touch and become one. What
 * was counted after `seen` was counted before the machine's clock was set back.
 */
export function countOnce(seen: Stretch, counted: Stretch | undefined): [number, Stretch] {
  const length = seen.to - seen.from;
  if (!counted || counted.to > seen.to || counted.to < seen.from) return [length / 1000, seen];
  const common = counted.to - Math.max(seen.from, counted.from);
  const from = Math.min(seen.from, counted.from);
  return [(length - common) / 1000, { from, to: seen.to }];
}
