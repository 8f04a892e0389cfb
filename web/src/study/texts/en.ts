import type { Texts } from "./table";

export const en: Texts = {
  name: "English",
  language: "Language",
  title: "3D tabletop scenes: a user study",
  thanks: "Thank you for taking part",
  welcome: [
    "This questionnaire is part of a study on the automatic generation of 3D tabletop scenes from one picture. It compares different methods.",
    "Your answers are anonymous and are used for research only. They contain a random number, your ratings and the time spent on each page, but nothing about you or your device.",
  ],
  task: (scenes, results) => [
    `${scenes === 1 ? "There is 1 page. It" : `There are ${scenes} pages. Each`} shows an input picture and ${results} results generated from it, in random order. Ignore the angle from which a result is shown.`,
    "Compare each result with the input picture and rate it from 1 to 7. Then choose the result that you prefer overall.",
  ],
  scale: "1 = very poor, 4 = average, 7 = excellent. Higher ratings mean better quality.",
  checks:
    "An extra item may tell you which number to choose. It checks that the questions are read.",
  keyboard:
    "With a keyboard: Tab moves from question to question, 1 to 7 or the arrow keys answer, Enter on a picture enlarges it.",
  resume: "You can close the page and continue later in this browser.",
  criteria: "What to consider",
  begin: "Begin",
  proceed: "Continue",
  scene: (number, count) => `Scene ${number} of ${count}`,
  input: "Input picture",
  result: (number) => `Result ${number}`,
  resultAbove: (number) => `Result ${number} from above`,
  enlarge: (picture) => `Enlarge: ${picture}`,
  questions: {
    visual_fidelity: {
      name: "Visual fidelity",
      question: "How good and realistic does the scene look?",
      consider:
        "Consider the overall appearance: the textures of the table and of the objects on it, the level of detail, and the completeness of the models.",
    },
    image_alignment: {
      name: "Image alignment",
      question: "How well does the scene match the input picture?",
      consider:
        "Consider the style, the categories and counts of objects, their layout, and how similar the models of the table and the objects are.",
    },
    physical_plausibility: {
      name: "Physical plausibility",
      question: "Is the scene physically reasonable?",
      consider:
        "Consider whether the table stands stably on the floor, whether all objects rest entirely on the table, and whether anything floats, or passes through something else.",
    },
    overall: {
      name: "Overall",
      question: "How good is the result, all things considered?",
      consider: "Weigh the three criteria as you see fit.",
    },
  },
  check: (level) => `Please choose ${level} here.`,
  checkName: "Attention check",
  levels: { 1: "very poor", 4: "average", 7: "excellent" },
  choice: "Overall, which result do you prefer?",
  unanswered: "not answered yet",
  open: (count) =>
    count === 1 ? "One question is not answered yet." : `${count} questions are not answered yet.`,
  back: "Back",
  next: "Next",
  finish: "Finish",
  done: "You have answered everything.",
  saved: (file) =>
    `Your answers were saved as the file ${file}. Please send it to the person who asked you to take part.`,
  sending: "Your answers are being sent …",
  sent: "Your answers were sent. You can close this page.",
  notSent:
    "Your answers could not be sent. They are kept in this browser: try again, or download them and send the file to the person who asked you to take part.",
  again: "Try again",
  download: "Download the answers",
  startOver: "Start over",
  startOverWarning: "This deletes your answers in this browser and starts again with other scenes.",
  startOverYes: "Delete and start over",
  cancel: "Cancel",
  notKept: "This browser does not save your progress: do not close or reload the page before the end.",
  close: "Close",
  previous: "Previous picture",
  following: "Next picture",
  larger: "Larger",
  smaller: "Smaller",
  missing: "This page contains no study. Create one with the command “study new”.",
};
