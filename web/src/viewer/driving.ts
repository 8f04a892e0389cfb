/** Keys that drive the arm, as in `tabletopgen teleop`. */
import type { ArmAction } from "../physics/protocol";

export const KEYS: readonly [string, string][] = [
  ["W S", "away from you, towards you"],
  ["A D", "left, right"],
  ["R F", "up, down"],
  ["Q E", "turn the hand"],
  ["Space", "open or close the gripper"],
  ["Shift", "slowly"],
];

const HELD = new Set(["w", "s", "a", "d", "r", "f", "q", "e", "shift"]);

export class Driving {
  private readonly held = new Set<string>();
  private open = true;

  /** Handles a key; returns whether it drives the arm. */
  key(event: KeyboardEvent, down: boolean): boolean {
    if (down && (event.ctrlKey || event.metaKey || event.altKey)) return false;
    const key = event.key.toLowerCase();
    if (key === " ") {
      if (down && !event.repeat) this.open = !this.open;
      return true;
    }
    if (!HELD.has(key)) return false;
    if (down) this.held.add(key);
    else this.held.delete(key);
    return true;
  }

  clear(): void {
    this.held.clear();
  }

  /** Resets the keys: none is pressed, and the gripper is open. */
  reset(): void {
    this.clear();
    this.open = true;
  }

  get gripper(): "open" | "closed" {
    return this.open ? "open" : "closed";
  }

  /**
   * Returns the current action.
   *
   * @param turn - the direction "away from you" of the view, about the vertical, in the frame of the
   *   robot's base, radians from its x axis.
   */
  action(turn: number): ArmAction {
    const on = (key: string): number => (this.held.has(key) ? 1 : 0);
    const scale = this.held.has("shift") ? 0.3 : 1;
    const away = on("w") - on("s");
    const left = on("a") - on("d");
    const x = Math.cos(turn) * away - Math.sin(turn) * left;
    const y = Math.sin(turn) * away + Math.cos(turn) * left;
    return [x * scale, y * scale, (on("r") - on("f")) * scale, (on("q") - on("e")) * scale, this.open ? 1 : -1];
  }
}
