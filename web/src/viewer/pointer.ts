/** Pointer input on the canvas: names on hover, objects dragged and thrown. */
import * as THREE from "three";
import type { BuiltModel } from "./meshes";
import type { Stage } from "./stage";

export interface Grip {
  body: number;
  /** The held point in the body's frame, and its initial position in the world. */
  local: THREE.Vector3;
  held: THREE.Vector3;
}

export interface PointerEvents {
  /** The body under the pointer; -1 for none. */
  hover(body: number, x: number, y: number): void;
  /** A body was clicked but not dragged; -1 for none. */
  click(body: number): void;
  drag(grip: Grip, target: THREE.Vector3, shift: boolean): void;
  /** The dragged body is released; `cancelled` if the browser took the pointer away. */
  release(cancelled: boolean): void;
  /** Whether a body can be dragged. */
  movable(body: number): boolean;
  /** Whether objects are always dragged in a horizontal plane, not only with Shift. */
  level(): boolean;
}

/** Maximum motion of a click, pixels. */
const CLICK = 4;

export class Pointer {
  private readonly ray = new THREE.Raycaster();
  private readonly plane = new THREE.Plane();
  private grip: Grip | null = null;
  private pressed: { x: number; y: number; body: number; id: number } | null = null;
  private readonly stop = new AbortController();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly stage: Stage,
    private readonly model: () => BuiltModel | null,
    private readonly events: PointerEvents,
  ) {
    const options = { signal: this.stop.signal };
    canvas.addEventListener("pointermove", (event) => this.move(event), options);
    canvas.addEventListener("pointerdown", (event) => this.press(event), { ...options, capture: true });
    canvas.addEventListener("pointerup", (event) => this.lift(event), options);
    canvas.addEventListener("pointercancel", (event) => this.lift(event), options);
    canvas.addEventListener("pointerleave", () => events.hover(-1, 0, 0), options);
  }

  dispose(): void {
    this.stop.abort();
  }

  private aim(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    this.ray.setFromCamera(new THREE.Vector2(x, y), this.stage.camera);
  }

  private hit(event: PointerEvent): THREE.Intersection | null {
    const model = this.model();
    if (!model) return null;
    this.aim(event);
    return this.ray.intersectObject(model.root, true).find(({ object }) => object.visible) ?? null;
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary) return;
    const found = this.hit(event);
    const body = (found?.object.userData.body as number | undefined) ?? -1;
    this.pressed = { x: event.clientX, y: event.clientY, body, id: event.pointerId };
    const group = this.model()?.bodies[body]?.group;
    if (!found || !group || !this.events.movable(body)) return;
    this.grip = { body, local: group.worldToLocal(found.point.clone()), held: found.point.clone() };
    const level = event.shiftKey || this.events.level();
    const normal = level ? new THREE.Vector3(0, 0, 1) : this.stage.camera.getWorldDirection(new THREE.Vector3());
    this.plane.setFromNormalAndCoplanarPoint(normal, found.point);
    this.stage.controls.enabled = false; // the camera is fixed while an object is dragged
    this.canvas.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    if (this.grip) {
      this.aim(event);
      const target = this.ray.ray.intersectPlane(this.plane, new THREE.Vector3());
      if (target) this.events.drag(this.grip, target, event.shiftKey);
      this.name(this.grip.body, event);
      return;
    }
    if (event.buttons !== 0 || event.pointerType === "touch") return;
    this.name((this.hit(event)?.object.userData.body as number | undefined) ?? -1, event);
  }

  private name(body: number, event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    this.events.hover(body, event.clientX - box.left, event.clientY - box.top);
  }

  private lift(event: PointerEvent): void {
    const { pressed } = this;
    if (!pressed || pressed.id !== event.pointerId) return;
    this.pressed = null;
    if (this.grip) {
      this.grip = null;
      this.stage.controls.enabled = true;
      this.events.release(event.type === "pointercancel");
      this.events.hover(-1, 0, 0);
    }
    const still = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < CLICK;
    if (still && event.type === "pointerup") this.events.click(pressed.body);
  }
}
