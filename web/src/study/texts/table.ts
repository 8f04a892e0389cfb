/** The texts required of every language. */
import type { Question } from "../study";

export interface QuestionTexts {
  name: string;
  /** The question on one line. */
  question: string;
  /** Aspects to consider. */
  consider: string;
}

export interface Texts {
  /** Name of the language in itself. */
  name: string;
  language: string;
  title: string;
  thanks: string;
  welcome: string[];
  task(scenes: number, results: number): string[];
  scale: string;
  checks: string;
  keyboard: string;
  resume: string;
  criteria: string;
  begin: string;
  proceed: string;
  scene(number: number, count: number): string;
  input: string;
  result(number: number): string;
  resultAbove(number: number): string;
  enlarge(picture: string): string;
  questions: Record<Question, QuestionTexts>;
  check(level: number): string;
  checkName: string;
  /** Meanings of the lowest, middle and highest rating. */
  levels: { 1: string; 4: string; 7: string };
  choice: string;
  unanswered: string;
  open(count: number): string;
  back: string;
  next: string;
  finish: string;
  done: string;
  saved(file: string): string;
  sending: string;
  sent: string;
  notSent: string;
  again: string;
  download: string;
  startOver: string;
  startOverWarning: string;
  startOverYes: string;
  cancel: string;
  notKept: string;
  close: string;
  previous: string;
  following: string;
  larger: string;
  smaller: string;
  missing: string;
}
