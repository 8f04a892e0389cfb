/** The time for which the page is visible, counted once even if several tabs are visible. */

const TICK = 5; // seconds between updates of the clock
const LONGEST = 30; // maximum seconds per update: the machine may have been suspended

/** A time interval; milliseconds since 1970. */
export interface Stretch {
  from: number;
  to: number;
}

/** Calls `add` with the intervals in which the page was visible; returns a function that calls it immediately. */
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
 * Returns the seconds of `seen` that are not in `counted`, and the new counted interval.
 *
 * Tabs that are visible at the same time report in turn, so their intervals touch and merge. A
 * counted interval after `seen` means that the machine's clock was set back.
 */
export function countOnce(seen: Stretch, counted: Stretch | undefined): [number, Stretch] {
  const length = seen.to - seen.from;
  if (!counted || counted.to > seen.to || counted.to < seen.from) return [length / 1000, seen];
  const common = counted.to - Math.max(seen.from, counted.from);
  const from = Math.min(seen.from, counted.from);
  return [(length - common) / 1000, { from, to: seen.to }];
}
