/** A rater's progress: stored in the browser, and validated when it is read. */
import type { Stretch } from "./clock";
import { newRater } from "./random";
import { isLevel, QUESTIONS, type Question, type Study } from "./study";
import { isLanguage, type Language, usualLanguage } from "./texts";

export type Marks = Partial<Record<Question, number>>;

export interface Progress {
  rater: string;
  language: Language;
  /** 0 is the introduction, 1 the first scene, and the number of scenes plus 1 the end. */
  place: number;
  /** Viewing time of each scene, by scene. */
  seconds: Record<string, number>;
  /** The last counted interval of any tab. */
  counted?: Stretch;
  /** By result. */
  marks: Record<string, Marks>;
  /** The preferred result, by scene. */
  choices: Record<string, string>;
  /** The chosen number in an attention check, by scene. */
  checks: Record<string, number>;
  /** Whether a server accepted the answers. */
  sent: boolean;
}

const MOST_CHARACTERS = 2 ** 19;

const key = (study: Study): string => `study-${study.study}`;

export function newProgress(language: Language = usualLanguage()): Progress {
  const none = { seconds: {}, marks: {}, choices: {}, checks: {} };
  return { rater: newRater(), language, place: 0, ...none, sent: false };
}

/** Stores the progress; returns false if the browser does not. */
export function keep(study: Study, progress: Progress): boolean {
  try {
    localStorage.setItem(key(study), JSON.stringify(progress));
    return true;
  } catch {
    return false;
  }
}

/** Returns the stored progress of this study; null if it is invalid. */
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

/** Returns whether a storage event is about this study. */
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
