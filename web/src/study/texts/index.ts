/** The texts of the page by language; a new language needs one more table and one more line. */
import { en } from "./en";
import type { Texts } from "./table";
import { zh } from "./zh";

export type { Texts } from "./table";

export const TEXTS = { en, zh } as const satisfies Record<string, Texts>;

export type Language = keyof typeof TEXTS;

export const LANGUAGES = Object.keys(TEXTS) as Language[];

export const isLanguage = (value: unknown): value is Language =>
  typeof value === "string" && Object.hasOwn(TEXTS, value);

/** Returns the browser's first language with texts, English by default. */
export function usualLanguage(): Language {
  const wanted = navigator.languages.map((tag) => tag.split("-")[0]);
  return wanted.find(isLanguage) ?? "en";
}
