/** A live scene for the interface: drawing, view and pointer; components observe its signals. */
import { signal } from "@preact/signals";
import * as THREE from "three";
import { ROBOT } from "../physics/names";
import type { Frame, ModelData } from "../physics/protocol";
import { LiveScene } from "./live";
import { Marks } from "./marks";
import { BuiltModel } from "./meshes";
import { PlaceCheck } from "./place_check";
import { Placing, type Move } from "./placing";
import { Pointer, type Grip } from "./pointer";
import { Stage } from "./stage";

export interface Hover {
  name: string;
  x: number;
  y: number;
}

export class Engine extends LiveScene {
  readonly hover = signal<Hover | null>(null);
  readonly selected = signal<string | null>(null);
  /** Why the moved object cannot stand at its current position; null if it can. */
  readonly blocked = signal<string | null>(null);
  readonly parts = signal(false);
  /** Whether the camera is that of the picture, and the opacity of the picture over the view. */
  readonly inPicture = signal(false);
  readonly onion = signal(0);
  /** Called when a person has moved an object, while `editing`. */
  onMoved: (name: string, move: Move) => void = () => {};
  /** Whether a move is being saved: no other one can start meanwhile. */
  locked = false;
  /** The initial view (`Stage.view`); null for the default one. */
  firstView: number[] | null = null;
  stage: Stage | null = null;
  private model: BuiltModel | null = null;
  private marks: Marks | null = null;
  private pointer: Pointer | null = null;
  private placing: Placing | null = null;
  private check: PlaceCheck | null = null;
  private unseen = false;

  /** Draws on a canvas; `error` has a message if the browser cannot. */
  attach(canvas: HTMLCanvasElement): void {
    try {
      this.stage = new Stage(canvas);
    } catch {
      this.error.value = "This browser does not provide WebGL, which the 3D view needs. Enable hardware acceleration, or use another browser.";
      return;
    }
    this.begin();
    this.stage.onMove = () => {
      this.inPicture.value = false;
      this.onion.value = 0;
    };
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      if (!this.closed) this.error.value = "Out of graphics memory. Close other tabs, then reload this page.";
    });
    this.pointer = new Pointer(canvas, this.stage, () => this.model, {
      hover: (body, x, y) => this.point(body, x, y),
      click: (body) => this.select(body),
      drag: (grip, target, shift) => this.drag(grip, target, shift),
      release: (cancelled) => this.release(cancelled),
      movable: (body) => this.movable(body),
      level: () => this.editing.value,
    });
  }

  protected build(data: ModelData, what: "scene" | "arm"): void {
    if (!this.stage) return;
    const first = this.model === null;
    this.model?.dispose();
    this.marks?.dispose();
    this.model = new BuiltModel(data, this.stage.renderer.capabilities.getMaxAnisotropy());
    this.marks = new Marks(data.bodies.flatMap((body, k) => (body.moves ? [k] : [])));
    this.stage.scene.add(this.model.root, this.marks.root);
    this.model.showParts(this.parts.value);
    this.unseen = first || what === "arm"; // the first frame has the initial poses
    this.choose(this.selected.value);
  }

  /** The direction "away from the viewer", about the vertical, from the robot's x axis, radians. */
  protected heading(): number {
    const camera = this.stage?.camera.getWorldDirection(new THREE.Vector3()) ?? new THREE.Vector3(1, 0, 0);
    const base = this.robot();
    const ahead = new THREE.Vector3(1, 0, 0).applyQuaternion(base?.quaternion ?? new THREE.Quaternion());
    return Math.atan2(camera.y, camera.x) - Math.atan2(ahead.y, ahead.x);
  }

  /** Position of a body on the canvas, in pixels from its corner; for scripts and tests. */
  locate(name: string): { x: number; y: number } | null {
    const group = this.groupOf(name);
    if (!group || !this.stage) return null;
    const at = group.getWorldPosition(new THREE.Vector3()).project(this.stage.camera);
    const box = this.stage.renderer.domElement.getBoundingClientRect();
    return { x: ((at.x + 1) / 2) * box.width, y: ((1 - at.y) / 2) * box.height };
  }

  /** The robot's base, if present. */
  private robot(): THREE.Object3D | undefined {
    return this.groupOf(`${ROBOT}link0`);
  }

  /** The drawn group of a body, if present. */
  private groupOf(name: string | null): THREE.Object3D | undefined {
    return this.model?.bodies[this.bodyOf(name)]?.group;
  }

  private bodyOf(name: string | null): number {
    return this.model?.data.bodies.findIndex((body) => body.name === name) ?? -1;
  }

  /** The bodies that move with one: itself, the objects on or in it, and those on them. */
  private carriedBy(name: string): number[] {
    const names = [name];
    for (const beneath of names) {
      const above = this.files?.row.things.filter((thing) => thing.on === beneath) ?? [];
      names.push(...above.map((thing) => thing.name).filter((each) => !names.includes(each)));
    }
    return names.map((each) => this.bodyOf(each)).filter((body) => body >= 0);
  }

  // ----------------------------------------------------------------------------------------- view

  lookFrom(side: "front" | "top"): void {
    if (!this.model) return;
    const height = this.files?.row.table.size[2] ?? 0.7;
    const robot = this.robot()?.position;
    // With the robot, the view is from across the table and slightly aside.
    const azimuth = robot ? Math.atan2(-robot.x, robot.y) + 0.6 : -0.45;
    if (side === "top") this.stage?.frame(this.model.root, height - 0.05, robot ? azimuth - 0.6 : 0, 1.5);
    else this.stage?.frame(this.model.root, height - 0.3, azimuth);
    this.inPicture.value = false;
    this.onion.value = 0;
  }

  /** Shows the view of the picture, with the picture overlaid. */
  lookAsPicture(onion: number): void {
    const picture = this.files?.picture;
    const camera = this.model?.data.cameras.find(({ name }) => name === "reference");
    if (!picture || !camera || !this.stage) return;
    const top = this.files?.row.table.size[2] ?? 0.7;
    if (!this.inPicture.value) this.stage.enterPicture({ camera, aspect: picture.width / picture.height }, top);
    this.inPicture.value = true;
    this.onion.value = onion;
  }

  setShown(what: "parts" | "centres" | "contacts", on: boolean): void {
    this[what].value = on;
    if (what === "parts") this.model?.showParts(on);
    void this.tellShown();
    this.stage?.draw();
  }

  private select(body: number): void {
    const found = this.model?.data.bodies[body];
    this.choose(found?.free ? found.name : null);
  }

  /** Selects an object by name; null selects none. */
  choose(name: string | null): void {
    this.selected.value = name;
    this.marks?.select(this.groupOf(name) ?? null);
    this.stage?.draw();
  }

  private point(body: number, x: number, y: number): void {
    const name = this.model?.data.bodies[body]?.name ?? "";
    this.hover.value = body > 0 && name ? { name, x, y } : null;
  }

  private movable(body: number): boolean {
    const found = this.model?.data.bodies[body];
    if (!found || this.mode.value === "episode") return false;
    return this.editing.value ? found.free && this.mode.value === "scene" && !this.locked : found.moves;
  }

  private drag(grip: Grip, target: THREE.Vector3, shift: boolean): void {
    const { body, local, held } = grip;
    const group = this.model?.bodies[body]?.group;
    if (!group) return;
    if (this.editing.value) {
      this.place(body, held, target, shift);
    } else {
      if (!this.running.value) this.run(true);
      this.physics.tell({ kind: "drag", body, grip: local.toArray(), target: target.toArray() });
      this.marks?.showRope(group.localToWorld(local.clone()), target);
    }
    this.stage?.draw();
  }

  private place(body: number, held: THREE.Vector3, target: THREE.Vector3, shift: boolean): void {
    const { model } = this;
    if (!model) return;
    if (!this.placing) {
      const { name } = model.data.bodies[body]!;
      const bodies = this.carriedBy(name);
      const falls = this.files?.row.things.find((thing) => thing.name === name)?.on !== "table";
      this.run(false);
      this.select(body);
      this.placing = new Placing(bodies.map((each) => model.bodies[each]!.group), held);
      this.check = new PlaceCheck(model, bodies, falls, (placed) => this.physics.overlaps(placed), (why) => this.block(why));
    }
    this.placing.drag(target, shift);
    this.marks?.follow();
    const move = this.placing.end();
    if (move && (move.to || !this.check?.falls)) this.check?.look();
    else this.check?.forget();
  }

  private block(why: string | null): void {
    this.blocked.value = why;
    this.marks?.warn(why !== null);
    this.stage?.draw();
  }

  private release(cancelled: boolean): void {
    const { placing } = this;
    this.check?.forget();
    this.check = null;
    if (placing) {
      const move = cancelled ? null : placing.end();
      this.placing = null;
      if (move && this.selected.value) this.onMoved(this.selected.value, move);
      else placing.undo();
      this.marks?.follow();
    } else {
      this.physics.tell({ kind: "release" });
      this.marks?.showRope(null, null);
    }
    this.stage?.draw();
  }

  /** Starts or ends editing: the scene rests in its settled state. */
  edit(on: boolean): void {
    this.editing.value = on;
    if (!on || !this.ready.value) return;
    this.run(false);
    this.reset();
  }

  /** Draws everything at its simulated pose, after a rejected move. */
  putBack(): void {
    this.model?.forget();
    this.reset();
  }

  protected show(frame: Frame): void {
    this.time.value = frame.time;
    const marked = this.marks?.shown ?? false;
    this.marks?.showCentres(frame.centres);
    this.marks?.showContacts(frame.contacts);
    if (!this.model?.place(frame.poses) && !marked && !this.marks?.shown) return;
    this.marks?.follow();
    if (this.unseen) {
      this.unseen = false;
      this.lookFrom("front");
      if (this.firstView && this.stage) this.stage.view = this.firstView;
      this.firstView = null;
    }
    this.stage?.draw();
  }

  override close(): void {
    super.close();
    this.pointer?.dispose();
    this.marks?.dispose();
    this.model?.dispose();
    this.stage?.dispose();
  }
}
