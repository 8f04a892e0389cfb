/** The state of the page, and its changes. */
import { computed, effect, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { assign, type Page } from "./assignment";
import { countOnce, watchTime } from "./clock";
import { isAbout, keep, newProgress, type Progress, recall } from "./progress";
import { QUESTIONS, type Question, type Study } from "./study";
import { type Language, TEXTS, type Texts } from "./texts";

/** A picture that can be enlarged. */
export interface Picture {
  source: string;
  label: string;
}

export interface Zoom {
  pictures: Picture[];
  at: number;
}

export interface Store {
  study: Study;
  progress: Signal<Progress>;
  pages: ReadonlySignal<Page[]>;
  texts: ReadonlySignal<Texts>;
  /** Whether the browser stores the progress. */
  kept: ReadonlySignal<boolean>;
  zoom: Signal<Zoom | null>;
  change(changes: Partial<Progress>): void;
  mark(result: string, question: Question, level: number): void;
  go(place: number): void;
  setLanguage(language: Language): void;
  startOver(): void;
}

export function createStore(study: Study): Store {
  const progress = signal<Progress>(recall(study) ?? newProgress());
  const rater = computed(() => progress.value.rater);
  const pages = computed(() => assign(study, rater.value));
  const texts = computed(() => TEXTS[progress.value.language]);
  const kept = signal(true);
  const change = (changes: Partial<Progress>): void => {
    progress.value = { ...progress.value, ...changes };
  };
  effect(() => {
    kept.value = keep(study, progress.value);
  });
  effect(() => {
    document.documentElement.lang = progress.value.language;
  });
  const catchUp = (): void => {
    if (kept.value) progress.value = recall(study) ?? progress.value; // from another tab
  };
  const tick = watchTime((seen) => {
    catchUp();
    const { place, seconds: before } = progress.value;
    const scene = pages.value[place - 1]?.scene.id;
    const [fresh, counted] = countOnce(seen, progress.value.counted);
    if (!scene || fresh <= 0) return;
    change({ seconds: { ...before, [scene]: (before[scene] ?? 0) + fresh }, counted });
  });
  window.addEventListener("storage", (event) => {
    if (isAbout(study, event)) catchUp();
  });
  // A tab suspended by the browser has missed updates from other tabs.
  for (const again of ["pageshow", "visibilitychange"]) window.addEventListener(again, catchUp);
  return {
    study,
    progress,
    pages,
    texts,
    kept,
    zoom: signal<Zoom | null>(null),
    change,
    mark(result, question, level) {
      const marks = progress.value.marks;
      change({ marks: { ...marks, [result]: { ...marks[result], [question]: level } } });
    },
    go(place) {
      tick();
      change({ place });
    },
    setLanguage(language) {
      change({ language });
    },
    startOver() {
      progress.value = newProgress(progress.value.language);
    },
  };
}

/** Returns how many answers a page still needs. */
export function countOpen(page: Page, progress: Progress): number {
  const marks = page.results.flatMap(({ id }) => QUESTIONS.map((q) => progress.marks[id]?.[q]));
  const check = page.check ? [progress.checks[page.scene.id]] : [];
  const asked = [...marks, ...check, progress.choices[page.scene.id]];
  return asked.filter((answer) => answer === undefined).length;
}
