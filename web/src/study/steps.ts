/** Focus movement between questions: each is marked `data-step`, as is the button after them. */

/** Focuses the step after the one that contains `inside`. */
export function focusNext(inside: Element): void {
  const steps = [...document.querySelectorAll<HTMLElement>("[data-step]")];
  const own = inside.closest<HTMLElement>("[data-step]");
  const next = own ? steps[steps.indexOf(own) + 1] : undefined;
  if (next) focusStep(next);
}

/** Focuses the first question without an answer; returns whether there is one. */
export function focusFirstOpen(): boolean {
  const open = document.querySelector<HTMLElement>('[data-step="open"]');
  if (open) focusStep(open);
  return open !== null;
}

/** Returns the number of a digit key pressed without modifiers, from 1 to `most`; null for other keys. */
export function digitOf(event: KeyboardEvent, most: number): number | null {
  if (event.ctrlKey || event.altKey || event.metaKey) return null;
  const digit = /^[1-9]$/.test(event.key) ? Number(event.key) : 0;
  return digit >= 1 && digit <= most ? digit : null;
}

function focusStep(step: HTMLElement): void {
  const radio =
    step.querySelector<HTMLElement>("input:checked") ?? step.querySelector<HTMLElement>("input");
  (radio ?? step).focus();
}
