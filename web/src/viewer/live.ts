/** A scene and its physics: loading, running, modes and driving; `Engine` draws it. */
import { signal } from "@preact/signals";
import { fetchData, fetchEpisode, fetchModel, PageError, type EpisodeRow, type SceneFiles } from "../data";
import { Physics } from "../physics/client";
import type { ArmAction, Frame, ModelData, State } from "../physics/protocol";
import { Driving } from "./driving";
import { Player } from "./player";

export type Mode = "scene" | "arm" | "episode";

export abstract class LiveScene {
  readonly ready = signal(false);
  /** Why nothing can be shown any more. */
  readonly error = signal<string | null>(null);
  /** An error after which the scene can be shown again (`recover`). */
  readonly trouble = signal<string | null>(null);
  readonly running = signal(false);
  readonly time = signal(0);
  readonly mode = signal<Mode>("scene");
  readonly centres = signal(false);
  readonly contacts = signal(false);
  readonly gripper = signal<"open" | "closed">("open");
  /** Whether dragging an object moves it to a new place, instead of pulling it. */
  readonly editing = signal(false);
  readonly player = new Player((qpos, marker) => this.physics.tell({ kind: "pose", qpos, marker }));
  files: SceneFiles | null = null;
  protected readonly physics = new Physics(
    (frame) => this.show(frame),
    (message) => {
      this.player.stop();
      this.error.value = `The physics stopped: ${message}`;
    },
  );
  protected readonly stop = new AbortController();
  protected closed = false;
  protected data: ModelData | null = null;
  private readonly driving = new Driving();
  private base = "";
  /** The changes of mode, in sequence. */
  private changes: Promise<void> = Promise.resolve();

  /** Creates the drawn objects of a compiled model. */
  protected abstract build(data: ModelData, what: "scene" | "arm"): void;

  /** Draws an instant. */
  protected abstract show(frame: Frame): void;

  /** The direction "away from the viewer", about the vertical, from the robot's x axis, radians. */
  protected abstract heading(): number;

  /** Starts the physics, which pauses while the page is hidden. */
  protected begin(): void {
    this.physics.begin();
    const seen = (): void => void (this.ready.value && this.tellRunning());
    document.addEventListener("visibilitychange", seen, { signal: this.stop.signal });
  }

  /** Loads a scene's folder. */
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

  /** Reloads the scene after `trouble`. */
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

  /** Changes the mode after all earlier changes are done. */
  private change(work: () => Promise<void>): Promise<void> {
    this.changes = this.changes.then(work).catch((error: unknown) => this.fail(error));
    return this.changes;
  }

  private async load(what: "scene" | "arm"): Promise<void> {
    const files = what === "arm" ? this.files?.arm : this.files?.scene;
    if (!files) throw new PageError("There is no place for a robot at this table.");
    const [xml, parts] = await fetchModel(this.base, files);
    const data = await this.physics.load(xml, parts, files.start);
    if (this.closed) return;
    this.data = data;
    this.build(data, what);
    await this.tellShown();
  }

  run(running: boolean): void {
    this.running.value = running;
    this.tellRunning();
  }

  /** Pauses the simulation while the page is hidden. */
  private tellRunning(): void {
    this.physics.tell({ kind: "run", running: this.running.value && !document.hidden });
  }

  /** Plays or pauses the scene or episode. */
  toggle(): void {
    if (this.mode.value === "episode") this.player.setPlaying(!this.player.playing.value);
    else this.run(!this.running.value);
  }

  /** Restarts the scene or episode. */
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

  /** Advances the paused simulation by a number of steps; returns the state. For scripts and tests. */
  async advance(steps: number): Promise<State> {
    this.run(false);
    await this.physics.ask({ kind: "step", steps });
    return this.physics.state();
  }

  /** Drives the arm by a list of actions, each for a twentieth of a second; returns the state. */
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
    return this.data?.bodies.map(({ name, qpos }) => ({ name, qpos })) ?? [];
  }

  // ---------------------------------------------------------------------------------------- modes

  /** Adds the arm to the table or removes it; the scene restarts. */
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

  /** Plays an episode in the scene's folder. */
  play(row: EpisodeRow): Promise<void> {
    return this.playFile(this.base + row.file);
  }

  /** Plays the episode at an address. */
  playFile(url: string): Promise<void> {
    return this.change(async () => {
      const episode = await fetchEpisode(url);
      await this.enter("episode");
      if (!this.data || this.error.value) return;
      if (episode.nq !== this.data.nq) throw new PageError("This episode belongs to another scene.");
      this.player.start(episode, this.data);
    });
  }

  // ----------------------------------------------------------------------------------------- keys

  /** Handles a key that drives the arm; returns whether it does. */
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
    this.physics.tell({ kind: "arm", action: this.driving.action(this.heading()) });
  }

  protected async tellShown(): Promise<void> {
    await this.physics.ask({ kind: "show", centres: this.centres.value, contacts: this.contacts.value });
  }

  close(): void {
    this.closed = true;
    this.stop.abort();
    this.player.stop();
    this.physics.close();
  }
}
