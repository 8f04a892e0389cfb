/** Pages of one document: the fragment after "#/" selects the page. */
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
    return part; // an invalid address selects nothing
  }
}

/** The address of a page from its parts: "#/scene/ID". */
export const addressOf = (...parts: string[]): string => `#/${parts.map(encodeURIComponent).join("/")}`;

/** Follows the address from now on; call once. */
export function followAddress(): void {
  window.addEventListener("hashchange", (event) => {
    const [kind] = route.value;
    route.value = parts();
    const before = new URL(event.oldURL).hash;
    setTimeout(() => arrive(before, route.value[0] === kind)); // once the page is rendered
  });
}

/**
 * Moves the focus to the new page: to the link to the previous page, as when the reader returns to
 * a list, or else to the beginning. A page of the same kind keeps an existing focus.
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

/** Skips the common header of all pages. */
export function skip(event: Event): void {
  event.preventDefault(); // the address is the route
  focusMain();
}

/** Sets the document's title for the current page. */
export function useTitle(title: string): void {
  useLayoutEffect(() => {
    document.title = title;
  }, [title]);
}
