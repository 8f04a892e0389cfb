/** One compiled scene and its state: steps, frames to draw, and the pull of the pointer. */
import type { MainModule, MjData, MjModel, MjVFS } from "@mujoco/mujoco";
import { Arm } from "./arm";
import { describe } from "./describe";
import { idOf } from "./names";
import type { ArmAction, Frame, ModelData, Placed, State, Vector } from "./protocol";

/** A force like MuJoCo's own perturbation: a critically damped spring with stiffness per kilogram. */
const STIFFNESS = 160;
const DAMPING = 2 * Math.sqrt(STIFFNESS);

/** Overlaps shallower than this, metres, count as contact, as in the `edit` command. */
const TOUCH = 2e-4;

interface Drag {
  body: number;
  /** The held point in the body's frame, and its target in the world. */
  grip: Vector;
  target: Vector;
}

export class Simulation {
  readonly described: ModelData;
  private drag: Drag | null = null;
  private arm: Arm | null = null;
  /** Another state of the model, for testing poses. */
  private trial: MjData | null = null;
  private readonly flags: number;

  private constructor(
    private readonly mujoco: MainModule,
    private readonly model: MjModel,
    private readonly data: MjData,
    private readonly key: number,
  ) {
    this.described = describe(mujoco, model);
    this.flags = model.opt.enableflags;
    if (this.described.arm) this.arm = new Arm(mujoco, model, data);
    this.reset();
  }

  /**
   * Compiles a document.
   *
   * @param start - name of the keyframe to start from; if it does not exist, the model's default
   *     state.
   * @throws Error with MuJoCo's words if it cannot be compiled.
   */
  static compile(mujoco: MainModule, xml: string, files: [string, Uint8Array][], start: string): Simulation {
    const vfs: MjVFS = new mujoco.MjVFS();
    try {
      for (const [name, bytes] of files) vfs.addBuffer(name, bytes);
      const model = mujoco.MjModel.from_xml_string(xml, vfs);
      if (!model) throw new Error("MuJoCo cannot read the scene.");
      const data = new mujoco.MjData(model);
      try {
        return new Simulation(mujoco, model, data, idOf(mujoco, model, "KEY", start));
      } catch (error) {
        data.delete();
        model.delete();
        throw error;
      }
    } finally {
      vfs.delete();
    }
  }

  delete(): void {
    this.arm?.delete();
    this.trial?.delete();
    this.data.delete();
    this.model.delete();
  }

  get time(): number {
    return this.data.time;
  }

  get timestep(): number {
    return this.described.timestep;
  }

  reset(): void {
    if (this.key >= 0) this.mujoco.mj_resetDataKeyframe(this.model, this.data, this.key);
    else this.mujoco.mj_resetData(this.model, this.data);
    this.mujoco.mj_forward(this.model, this.data);
    this.drag = null;
    this.arm?.reset();
  }

  /** Advances by a number of steps; a driven arm receives commands at 20 Hz. */
  step(steps: number): void {
    for (let k = 0; k < steps; k++) {
      this.arm?.beforeStep();
      if (this.drag) this.pull(this.drag);
      this.mujoco.mj_step(this.model, this.data);
    }
  }

  /** Enables sleeping as in the document, or keeps all bodies awake, since sleeping bodies have no contacts. */
  allowSleep(allowed: boolean): void {
    const bits = this.mujoco.mjtEnableBit as unknown as Record<string, { value: number }>;
    const sleep = bits["mjENBL_SLEEP"]?.value ?? 0;
    const { opt } = this.model;
    opt.enableflags = allowed ? this.flags : this.flags & ~sleep;
    if (!allowed) this.mujoco.mj_forward(this.model, this.data);
  }

  drive(action: ArmAction | null): void {
    this.arm?.drive(action);
  }

  hold(body: number, grip: Vector, target: Vector): void {
    if (this.drag && this.drag.body !== body) this.release();
    this.drag = { body, grip, target };
  }

  release(): void {
    if (!this.drag) return;
    this.data.xfrc_applied.fill(0, 6 * this.drag.body, 6 * this.drag.body + 6);
    this.drag = null;
  }

  /** Shows a recorded instant without stepping. */
  pose(qpos: Float32Array, marker: Float32Array | null): void {
    this.data.qpos.set(qpos.subarray(0, this.model.nq));
    if (marker && this.data.mocap_pos.length >= 3) this.data.mocap_pos.set(marker.subarray(0, 3));
    this.mujoco.mj_kinematics(this.model, this.data);
    this.mujoco.mj_comPos(this.model, this.data);
  }

  state(): State {
    const contacts = this.data.contact;
    const count = contacts.size();
    contacts.delete();
    return {
      time: this.data.time,
      qpos: [...this.data.qpos],
      qvel: [...this.data.qvel],
      ctrl: [...this.data.ctrl],
      contacts: count,
    };
  }

  /** The bodies that free ones would overlap at other poses; the state is unchanged. */
  overlaps(placed: Placed[]): number[] {
    const { model, mujoco } = this;
    const trial = (this.trial ??= new mujoco.MjData(model));
    trial.qpos.set(this.data.qpos);
    const moved = new Set(placed.map(({ body }) => body));
    for (const { body, position, quaternion } of placed) {
      trial.qpos.set([...position, ...quaternion], this.described.bodies[body]!.qpos);
    }
    mujoco.mj_kinematics(model, trial);
    mujoco.mj_comPos(model, trial);
    mujoco.mj_collision(model, trial);
    const contacts = trial.contact;
    const found = new Set<number>();
    for (let k = 0; k < contacts.size(); k++) {
      const contact = contacts.get(k);
      if (!contact) continue;
      const pair: number[] = [model.geom_bodyid[contact.geom1], model.geom_bodyid[contact.geom2]];
      const others = pair.filter((body) => !moved.has(body) && this.described.bodies[body]?.moves);
      if (others.length === 1 && contact.dist < -TOUCH) found.add(others[0]!);
      contact.delete();
    }
    contacts.delete();
    return [...found];
  }

  frame(running: boolean, centres: boolean, contacts: boolean): Frame {
    const { nbody } = this.model;
    const position = this.data.xpos as Float64Array;
    const turn = this.data.xquat as Float64Array;
    const poses = new Float32Array(7 * nbody);
    for (let k = 0; k < nbody; k++) {
      poses.set(position.subarray(3 * k, 3 * k + 3), 7 * k);
      poses.set(turn.subarray(4 * k, 4 * k + 4), 7 * k + 3);
    }
    return {
      time: this.data.time,
      running,
      poses,
      centres: centres ? new Float32Array(this.data.xipos as Float64Array) : null,
      contacts: contacts ? this.contacts() : null,
    };
  }

  private contacts(): Float32Array {
    const found = this.data.contact;
    const force = new this.mujoco.DoubleBuffer(6);
    const out = new Float32Array(7 * found.size());
    for (let k = 0; k < found.size(); k++) {
      const contact = found.get(k);
      if (!contact) continue;
      this.mujoco.mj_contactForce(this.model, this.data, k, force);
      out.set(contact.pos as Float64Array, 7 * k);
      out.set((contact.frame as Float64Array).subarray(0, 3), 7 * k + 3);
      out[7 * k + 6] = (force.GetView() as Float64Array)[0]!;
      contact.delete();
    }
    force.delete();
    found.delete();
    return out;
  }

  private pull({ body, grip, target }: Drag): void {
    const { data } = this;
    const turn = (data.xmat as Float64Array).subarray(9 * body, 9 * body + 9);
    const at = (data.xpos as Float64Array).subarray(3 * body, 3 * body + 3);
    const centre = (data.xipos as Float64Array).subarray(3 * body, 3 * body + 3);
    const root: number = this.model.body_rootid[body];
    const about = (data.subtree_com as Float64Array).subarray(3 * root, 3 * root + 3);
    const motion = (data.cvel as Float64Array).subarray(6 * body, 6 * body + 6);
    const mass: number = this.model.body_subtreemass[root];
    const force: Vector = [0, 0, 0];
    const arm: Vector = [0, 0, 0];
    const held: Vector = [0, 0, 0];
    for (let i = 0; i < 3; i++) {
      held[i] = at[i]! + turn[3 * i]! * grip[0] + turn[3 * i + 1]! * grip[1] + turn[3 * i + 2]! * grip[2];
      arm[i] = held[i]! - centre[i]!;
    }
    const from: Vector = [held[0] - about[0]!, held[1] - about[1]!, held[2] - about[2]!];
    const spin: Vector = [motion[0]!, motion[1]!, motion[2]!];
    const turned = cross(spin, from); // velocity of the held point: linear + spin x arm
    for (let i = 0; i < 3; i++) {
      const speed = motion[3 + i]! + turned[i]!;
      force[i] = mass * (STIFFNESS * (target[i]! - held[i]!) - DAMPING * speed);
    }
    if (this.described.bodies[body]?.free) force[2] += mass * 9.81; // servos hold the arm
    data.xfrc_applied.set([...force, ...cross(arm, force)], 6 * body);
  }
}

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
