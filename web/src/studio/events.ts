/** Job events from the studio. */
import type { JobEvent } from "./api";

/** Milliseconds until events are requested again after an error. */
const AGAIN = 2000;

/**
 * Calls `heard` with each event after number `since`, then with new ones, until the returned
 * function is called. `connected` receives whether the studio is reachable; a lost connection is
 * reestablished and resumes. Hidden pages disconnect, because a browser limits the connections of
 * all its pages to one server.
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
      connected(false); // the browser reconnects unless it was rejected: a new studio has a new token
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
