/** What happens to jobs, as the studio tells it. */
import type { JobEvent } from "./api";

/** Milliseconds until a studio that refused to tell of events is asked again. */
const AGAIN = 2000;

/**
 * Calls `heard` with each event after the one numbered `since`, then with new ones, until the
 * function that it returns is called. `connected` hears whether the studio is reached; a lost
 * connection is made again, and goes on where it was. A page that nobody sees does without: a
 * browser keeps few connections to one server for all of its pages.
 */
export function listen(
  since: number,
  heard: (event: JobEvent) => void,
  connected: (is: boolean) => void = () => {},
): () => void {
  const stop = new AbortController();
  let last = since;
  let again = 0;
  let source: EventSource | null = null;
  const close = (): void => {
    clearTimeout(again);
    source?.close();
    source = null;
  };
  const open = (): void => {
    close();
    const opened = new EventSource(`/api/events?since=${last}`);
    source = opened;
    opened.onopen = () => connected(true);
    opened.onerror = () => {
      connected(false); // the browser tries again, unless it was refused: a new studio has a new token
      if (opened.readyState === EventSource.CLOSED) again = window.setTimeout(open, AGAIN);
    };
    opened.onmessage = (message) => {
      const event = JSON.parse(message.data as string) as JobEvent;
      last = event.seq;
      heard(event);
    };
  };
  document.addEventListener("visibilitychange", () => (document.hidden ? close() : open()), { signal: stop.signal });
  stop.signal.addEventListener("abort", close);
  if (!document.hidden) open();
  return () => stop.abort();
}
