/** How far a rater is: kept in the browser, and read back with suspicion. */
import type { Stretch } from "./clock";
import { newRater } from "./random";
import { isLevel, QUESTIONS, type Question, type Study } from "./study";
import { isLanguage, type Language, usualLanguage } from "./texts";

export type Marks = Partial<Record<Question, number>>;

export interface Progress {
  rater: string;
  language: Language;
  /** 0 is the introduction, 1 the first scene, one more than there are scenes the end. */
  place: number;
  /** How long each scene was looked at, by scene. */
  seconds: Record<string, number>;
  /** The time that was counted last, by whichever tab. */
  counted?: Stretch;
  /** By result. */
  marks: Record<string, Marks>;
  /** The preferred result, by scene. */
  choices: Record<string, string>;
  /** What was chosen in an attention check, by scene. */
  checks: Record<string, number>;
  /** Whether a server took the answers. */
  sent: boolean;
}

const MOST_CHARACTERS = 2 ** 19;

const key = (study: Study): string => `study-${study.study}`;

export function newProgress(language: Language = usualLanguage()): Progress {
  const none = { seconds: {}, marks: {}, choices: {}, checks: {} };
  return { rater: newRater(), language, place: 0, ...none, sent: false };
}

/** Keeps the progress; returns false where the browser does not. */
export function keep(study: Study, progress: Progress): boolean {
  try {
    localStorage.setItem(key(study), JSON.stringify(progress));
    return true;
  } catch {
    return false;
  }
}

/** Returns what was kept of this study; null if that is nothing that this page could have kept. */
export function recall(study: Study): Progress | null {
  try {
    const text = localStorage.getItem(key(study));
    if (text === null || text.length > MOST_CHARACTERS) return null;
    const found: unknown = JSON.parse(text);
    return isProgress(found, study) ? found : null;
  } catch {
    return null;
  }
}

/** Tells whether an event of the browser's store is about this study. */
export const isAbout = (study: Study, event: StorageEvent): boolean => event.key === key(study);

function isProgress(value: unknown, study: Study): value is Progress {
  if (!isRecord(value)) return false;
  const { rater, language, place, seconds, counted, marks, choices, checks, sent } = value;
  const scenes = new Set(study.scenes.map((scene) => scene.id));
  const results = new Set(study.scenes.flatMap((scene) => scene.results.map((one) => one.id)));
  return (
    typeof rater === "string" &&
    /^[0-9a-f]{16}$/.test(rater) &&
    isLanguage(language) &&
    Number.isInteger(place) &&
    (place as number) >= 0 &&
    (place as number) <= study.scenesEach + 1 &&
    typeof sent === "boolean" &&
    isTable(seconds, scenes, (time) => typeof time === "number" && time >= 0) &&
    (counted === undefined || isStretch(counted)) &&
    isTable(choices, scenes, (result) => results.has(result as string)) &&
    isTable(checks, scenes, isLevel) &&
    isTable(marks, results, (one) => isTable(one, new Set<string>(QUESTIONS), isLevel))
  );
}

const isStretch = (value: unknown): value is Stretch =>
  isRecord(value) &&
  typeof value.from === "number" &&
  typeof value.to === "number" &&
  value.from <= value.to;

function isTable(
  value: unknown,
  known: ReadonlySet<string>,
  isFine: (value: unknown) => boolean,
): boolean {
  return isRecord(value) && Object.entries(value).every(([k, v]) => known.has(k) && isFine(v));
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);
