/** A live scene: physics, drawing, pointer and keys together; the interface observes its signals. */
import { signal } from "@preact/signals";
import * as THREE from "three";
import { fetchData, fetchEpisode, fetchModel, PageError, type EpisodeRow, type SceneFiles } from "../data";
import { Physics } from "../physics/client";
import type { ArmAction, Frame, ModelData, State } from "../physics/protocol";
import { Driving } from "./driving";
import { Marks } from "./marks";
import { BuiltModel } from "./meshes";
import { Placing, type Move } from "./placing";
import { Player } from "./player";
import { Pointer, type Grip } from "./pointer";
import { Stage } from "./stage";

export type Mode = "scene" | "arm" | "episode";

export interface Hover {
  name: string;
  x: number;
  y: number;
}

export class Engine {
  readonly ready = signal(false);
  /** Why nothing can be shown any more. */
  readonly error = signal<string | null>(null);
  /** What did not work, while the scene itself can be shown again (`recover`). */
  readonly trouble = signal<string | null>(null);
  readonly running = signal(false);
  readonly time = signal(0);
  readonly mode = signal<Mode>("scene");
  readonly hover = signal<Hover | null>(null);
  readonly selected = signal<string | null>(null);
  readonly parts = signal(false);
  readonly centres = signal(false);
  readonly contacts = signal(false);
  /** Whether the camera is that of the picture, and how much of the picture lies over the view. */
  readonly inPicture = signal(false);
  readonly onion = signal(0);
  readonly gripper = signal<"open" | "closed">("open");
  readonly player = new Player((qpos, marker) => this.physics.tell({ kind: "pose", qpos, marker }));
  /** Whether dragging a thing moves it to a new place, in place of pulling it. */
  readonly editing = signal(false);
  /** Called when a person has put a thing elsewhere, while `editing`. */
  onMoved: (name: string, move: Move) => void = () => {};
  /** Whether a move is being made for good: no other one begins meanwhile. */
  locked = false;
  /** The view to begin with (`Stage.view`); null for the usual one. */
  firstView: number[] | null = null;
  files: SceneFiles | null = null;
  stage: Stage | null = null;
  private physics: Physics;
  private model: BuiltModel | null = null;
  private marks: Marks | null = null;
  private pointer: Pointer | null = null;
  private readonly driving = new Driving();
  private base = "";
  private closed = false;
  private placing: Placing | null = null;
  private unseen = false;
  /** The changes of mode, one after the other. */
  private changes: Promise<void> = Promise.resolve();
  private readonly stop = new AbortController();

  constructor() {
    this.physics = this.start();
  }

  private start(): Physics {
    return new Physics(
      (frame) => this.show(frame),
      (message) => (this.error.value = `The physics stopped: ${message}`),
    );
  }

  /** Draws on a canvas; a message in `error` says so where the browser cannot. */
  attach(canvas: HTMLCanvasElement): void {
    try {
      this.stage = new Stage(canvas);
    } catch {
      this.error.value = "This browser gives no WebGL, which the 3D view needs. Switch on hardware acceleration, or use another browser.";
      return;
    }
    this.physics.begin();
    const seen = (): void => void (this.ready.value && this.tellRunning());
    document.addEventListener("visibilitychange", seen, { signal: this.stop.signal });
    this.stage.onMove = () => {
      this.inPicture.value = false;
      this.onion.value = 0;
    };
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      if (!this.closed) this.error.value = "The graphics memory ran out. Close other tabs, then load this page again.";
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

  /** Opens a scene's folder. */
  async open(base: string, running = true): Promise<void> {
    this.base = base;
    this.error.value = null;
    try {
      if (typeof WebAssembly !== "object") {
        throw new PageError("This browser has no WebAssembly, which the physics needs. Use a newer browser.");
      }
      this.files = await fetchData<SceneFiles>(`${base}view.json`);
      await this.load("scene");
      this.run(running && !this.editing.value);
      this.ready.value = true;
    } catch (error) {
      this.fail(error);
    }
  }

  private fail(error: unknown): void {
    if (this.closed) return;
    const words = error instanceof Error ? error.message : String(error);
    const told = error instanceof PageError ? words : `This scene cannot be shown: ${words}`;
    (this.ready.value ? this.trouble : this.error).value = told;
  }

  /** Shows the scene anew after `trouble`. */
  recover(): Promise<void> {
    return this.change(async () => {
      this.trouble.value = null;
      this.player.stop();
      this.driving.reset();
      await this.load("scene");
      this.mode.value = "scene";
      this.run(!this.editing.value);
    });
  }

  /** Does a change of mode once those before it are done. */
  private change(work: () => Promise<void>): Promise<void> {
    this.changes = this.changes.then(work).catch((error: unknown) => this.fail(error));
    return this.changes;
  }

  private async load(what: "scene" | "arm"): Promise<ModelData> {
    const files = what === "arm" ? this.files?.arm : this.files?.scene;
    if (!files) throw new PageError("No robot can be put at this table.");
    const [xml, parts] = await fetchModel(this.base, files);
    const data = await this.physics.load(xml, parts, files.start);
    if (this.closed || !this.stage) return data;
    const first = this.model === null;
    this.model?.dispose();
    this.marks?.dispose();
    this.model = new BuiltModel(data, this.stage.renderer.capabilities.getMaxAnisotropy());
    this.marks = new Marks(data.bodies.flatMap((body, k) => (body.moves ? [k] : [])));
    this.stage.scene.add(this.model.root, this.marks.root);
    this.model.showParts(this.parts.value);
    this.unseen = first || what === "arm"; // the first frame says where things are
    await this.tellShown();
    return data;
  }

  // ---------------------------------------------------------------------------------- simulation

  run(running: boolean): void {
    this.running.value = running;
    this.tellRunning();
  }

  /** Nothing is simulated while nobody sees the page. */
  private tellRunning(): void {
    this.physics.tell({ kind: "run", running: this.running.value && !document.hidden });
  }

  /** Plays or pauses whatever is shown. */
  toggle(): void {
    if (this.mode.value === "episode") this.player.setPlaying(!this.player.playing.value);
    else this.run(!this.running.value);
  }

  /** Begins whatever is shown anew. */
  restart(): void {
    if (this.mode.value !== "episode") this.reset();
    else {
      this.player.seek(0);
      this.player.setPlaying(true);
    }
  }

  step(steps = 1): void {
    this.run(false);
    this.physics.tell({ kind: "step", steps });
  }

  reset(): void {
    this.physics.tell({ kind: "reset" });
    this.driving.reset(); // the gripper is open again
    this.gripper.value = "open";
  }

  /** Advances by a number of steps, paused; returns the state. For scripts and tests. */
  async advance(steps: number): Promise<State> {
    this.run(false);
    await this.physics.ask({ kind: "step", steps });
    return this.physics.state();
  }

  /** Drives the arm by a list of actions, a twentieth of a second each; returns the state. */
  async act(actions: ArmAction[]): Promise<State> {
    this.run(false);
    await this.physics.ask({ kind: "reset" });
    for (const action of actions) {
      await this.physics.ask({ kind: "arm", action });
      await this.physics.ask({ kind: "step", steps: 25 });
    }
    return this.physics.state();
  }

  state(): Promise<State> {
    return this.physics.state();
  }

  bodies(): { name: string; qpos: number }[] {
    return this.model?.data.bodies.map(({ name, qpos }) => ({ name, qpos })) ?? [];
  }

  /** Where a body is on the canvas, in pixels from its corner; for scripts and tests. */
  locate(name: string): { x: number; y: number } | null {
    const k = this.model?.data.bodies.findIndex((body) => body.name === name) ?? -1;
    const group = this.model?.bodies[k]?.group;
    if (!group || !this.stage) return null;
    const at = group.getWorldPosition(new THREE.Vector3()).project(this.stage.camera);
    const box = this.stage.renderer.domElement.getBoundingClientRect();
    return { x: ((at.x + 1) / 2) * box.width, y: ((1 - at.y) / 2) * box.height };
  }

  // ---------------------------------------------------------------------------------------- modes

  /** Puts the arm at the table, or takes it away; the scene starts anew. */
  setMode(mode: Mode): Promise<void> {
    return this.change(() => this.enter(mode));
  }

  private async enter(mode: Mode): Promise<void> {
    if (this.mode.value === mode) return;
    const before = this.mode.value;
    this.player.stop();
    if ((before === "scene") !== (mode === "scene")) await this.load(mode === "scene" ? "scene" : "arm");
    this.reset();
    this.mode.value = mode;
    this.run(mode !== "episode" && !(mode === "scene" && this.editing.value));
    if (mode === "arm") this.drive();
  }

  /** Plays an episode of the scene's folder. */
  play(row: EpisodeRow): Promise<void> {
    return this.playFile(this.base + row.file);
  }

  /** Plays the episode at an address. */
  playFile(url: string): Promise<void> {
    return this.change(async () => {
      const episode = await fetchEpisode(url);
      await this.enter("episode");
      if (!this.model || this.error.value) return;
      if (episode.nq !== this.model.data.nq) throw new PageError("This episode is of another scene.");
      this.player.start(episode, this.model.data);
    });
  }

  // ----------------------------------------------------------------------------------------- keys

  /** Heeds a key that drives the arm; returns whether it does. */
  key(event: KeyboardEvent, down: boolean): boolean {
    if (this.mode.value !== "arm" || !this.driving.key(event, down)) return false;
    this.gripper.value = this.driving.gripper;
    this.drive();
    return true;
  }

  /** Holds down a key of the arm; for buttons on the screen. */
  press(key: string, down: boolean): void {
    this.key(new KeyboardEvent(down ? "keydown" : "keyup", { key }), down);
  }

  releaseKeys(): void {
    this.driving.clear();
    if (this.mode.value === "arm") this.drive();
  }

  private drive(): void {
    const camera = this.stage?.camera.getWorldDirection(new THREE.Vector3()) ?? new THREE.Vector3(1, 0, 0);
    const base = this.robot();
    const ahead = new THREE.Vector3(1, 0, 0).applyQuaternion(base?.quaternion ?? new THREE.Quaternion());
    const turn = Math.atan2(camera.y, camera.x) - Math.atan2(ahead.y, ahead.x);
    this.physics.tell({ kind: "arm", action: this.driving.action(turn) });
  }

  /** The robot's base, if it is there. */
  private robot(): THREE.Object3D | undefined {
    const k = this.model?.data.bodies.findIndex((body) => body.name === "panda/link0") ?? -1;
    return this.model?.bodies[k]?.group;
  }

  // ----------------------------------------------------------------------------------------- view

  lookFrom(side: "front" | "top"): void {
    if (!this.model) return;
    const height = this.files?.row.table.size[2] ?? 0.7;
    const robot = this.robot()?.position;
    // With the robot there, from across the table and a little aside.
    const azimuth = robot ? Math.atan2(-robot.x, robot.y) + 0.6 : -0.45;
    if (side === "top") this.stage?.frame(this.model.root, height - 0.05, robot ? azimuth - 0.6 : 0, 1.5);
    else this.stage?.frame(this.model.root, height - 0.3, azimuth);
    this.inPicture.value = false;
    this.onion.value = 0;
  }

  /** Looks as the picture does, with some of it over the view. */
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

  private async tellShown(): Promise<void> {
    await this.physics.ask({ kind: "show", centres: this.centres.value, contacts: this.contacts.value });
  }

  private select(body: number): void {
    const found = this.model?.data.bodies[body];
    this.choose(found?.free ? found.name : null);
  }

  /** Selects a thing by its name; null selects none. */
  choose(name: string | null): void {
    this.selected.value = name;
    const k = this.model?.data.bodies.findIndex((body) => body.name === name) ?? -1;
    this.marks?.select(this.model?.bodies[k]?.group ?? null);
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
      if (!this.placing) {
        this.run(false);
        this.select(body);
        this.placing = new Placing(group, held);
      }
      this.placing.drag(target, shift);
      this.marks?.follow();
    } else {
      if (!this.running.value) this.run(true);
      this.physics.tell({ kind: "drag", body, grip: local.toArray(), target: target.toArray() });
      this.marks?.showRope(group.localToWorld(local.clone()), target);
    }
    this.stage?.draw();
  }

  private release(cancelled: boolean): void {
    const { placing } = this;
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

  /** Begins or ends editing: the scene rests as it was settled. */
  edit(on: boolean): void {
    this.editing.value = on;
    if (!on || !this.ready.value) return;
    this.run(false);
    this.reset();
  }

  /** Draws everything where the simulation has it, after a move that was refused. */
  putBack(): void {
    this.model?.forget();
    this.reset();
  }

  private show(frame: Frame): void {
    this.time.value = frame.time;
    if (!this.model?.place(frame.poses) && !frame.centres && !frame.contacts) return;
    this.marks?.follow();
    if (this.unseen) {
      this.unseen = false;
      this.lookFrom("front");
      if (this.firstView && this.stage) this.stage.view = this.firstView;
      this.firstView = null;
    }
    this.marks?.showCentres(frame.centres);
    this.marks?.showContacts(frame.contacts);
    this.stage?.draw();
  }

  close(): void {
    this.closed = true;
    this.stop.abort();
    this.player.stop();
    this.physics.close();
    this.pointer?.dispose();
    this.marks?.dispose();
    this.model?.dispose();
    this.stage?.dispose();
  }
}
