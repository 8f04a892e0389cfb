/** Pages of one document: what follows "#/" in the address says which of them is shown. */
import { signal } from "@preact/signals";
import { useLayoutEffect } from "preact/hooks";

/** The parts of the address, decoded. */
export const route = signal<string[]>(parts());

function parts(): string[] {
  return location.hash.replace(/^#\/?/, "").split("/").filter(Boolean).map(decode);
}

function decode(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part; // a damaged address names nothing
  }
}

/** The address of a page by its parts: "#/scene/ID". */
export const addressOf = (...parts: string[]): string => `#/${parts.map(encodeURIComponent).join("/")}`;

/** Follows the address from now on; to be called once. */
export function followAddress(): void {
  window.addEventListener("hashchange", (event) => {
    const [kind] = route.value;
    route.value = parts();
    const before = new URL(event.oldURL).hash;
    setTimeout(() => arrive(before, route.value[0] === kind)); // once the page is there
  });
}

/**
 * Moves the focus to the new page, which has none: to the link that leads back to where the reader
 * was, as on the way back to a list, else to its beginning. A page of the same kind that kept the
 * focus keeps it.
 */
function arrive(before: string, same: boolean): void {
  const lost = !document.activeElement || document.activeElement === document.body;
  if (same && !lost) return;
  const main = document.getElementById("main");
  const links = [...(main?.querySelectorAll("a") ?? [])];
  const back = links.find((link) => link.getAttribute("href") === before);
  if (back) back.focus();
  else focusMain();
}

function focusMain(): void {
  scrollTo(0, 0);
  const main = document.getElementById("main");
  main?.setAttribute("tabindex", "-1");
  main?.focus({ preventScroll: true });
}

/** Passes over what all pages begin with. */
export function skip(event: Event): void {
  event.preventDefault(); // the address is the route
  focusMain();
}

/** Calls the document by the page that is shown. */
export function useTitle(title: string): void {
  useLayoutEffect(() => {
    document.title = title;
  }, [title]);
}
