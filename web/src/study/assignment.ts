/** The scenes of a rater, the order of their results, and the positions of the attention checks. */
import { type Random, seededRandom, shuffle } from "./random";
import { LEVELS, type Result, type Scene, type Study } from "./study";

/** An item of a result's card that tells the rater which number to choose. */
export interface Check {
  result: string;
  asked: number;
}

export interface Page {
  scene: Scene;
  /** The scene's results in display order. */
  results: Result[];
  check: Check | null;
}

/**
 * Returns a rater's pages, which depend on the rater's id.
 *
 * Scenes are drawn without replacement. Each order of results is random, and orders are balanced
 * within a rater: in as many consecutive scenes as there are methods, each method appears once in
 * every position (the shuffled rows of a Latin square).
 */
export function assign(study: Study, rater: string): Page[] {
  const random = seededRandom(`${study.study}:${rater}`);
  const scenes = shuffle(study.scenes, random).slice(0, study.scenesEach);
  const methods = scenes[0]?.results.length ?? 0;
  const orders: number[][] = [];
  while (orders.length < scenes.length) orders.push(...latinSquare(methods, random));
  const checked = new Set(shuffle(scenes, random).slice(0, study.attention));
  return scenes.map((scene, k) => {
    const results = (orders[k] ?? []).flatMap((column) => scene.results[column] ?? []);
    return { scene, results, check: checked.has(scene) ? drawCheck(results, random) : null };
  });
}

function latinSquare(size: number, random: Random): number[][] {
  const columns = shuffle([...Array(size).keys()], random);
  const shifts = shuffle([...Array(size).keys()], random);
  return shifts.map((shift) => columns.map((_, k) => columns[(k + shift) % size] ?? 0));
}

function drawCheck(results: Result[], random: Random): Check | null {
  const result = results[Math.floor(random() * results.length)];
  const asked = LEVELS[Math.floor(random() * LEVELS.length)];
  return result && asked ? { result: result.id, asked } : null;
}
