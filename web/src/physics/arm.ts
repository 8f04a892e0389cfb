/**
 * Drives the Panda as the environments' action mode `ee_delta` does, 20 times a second.
 *
 * The commanded point moves by an action, with a limited lead over the measured one, and the joints
 * follow by damped least squares; see `tabletopgen_env/actions/tool.py` and `robot/kinematics.py`.
 */
import type { DoubleBuffer, MainModule, MjData, MjModel } from "@mujoco/mujoco";
import { add, clamp, dot, rotationVector, solveSpd, sub, times, transpose } from "./linear";
import { idOf, ROBOT } from "./names";
import type { ArmAction } from "./protocol";

const HZ = 20;
const STEP = 0.025; // metres per action
const TURN = 0.15; // radians per action
const LEASH = 0.04; // metres
const YAW_LEASH = 0.4; // radians
const LOWEST = [-0.5, -0.8, -0.1];
const HIGHEST = [0.85, 0.8, 0.7];
const PULL = 0.05;
const MARGIN = 0.02;
const ELBOW = -0.62;
const MAX_STEP = 0.2;
const LEAD = 0.08; // seconds
const GRIPPER_OPEN = 255;
const HOME = [0, 0, 0, -Math.PI / 2, 0, Math.PI / 2, -Math.PI / 4];
const SPEED = [2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61]; // rad/s, rated

const JOINTS = Array.from({ length: 7 }, (_, k) => `${ROBOT}joint${k + 1}`);

export class Arm {
  private readonly probe: MjData;
  private readonly jacp: DoubleBuffer;
  private readonly jacr: DoubleBuffer;
  private readonly site: number;
  private readonly base: number;
  private readonly qpos: number[];
  private readonly dof: number[];
  private readonly low: number[];
  private readonly high: number[];
  private readonly every: number;
  private action: ArmAction | null = null;
  /** Steps until the next action, and the start and end of the servo commands until then. */
  private due = 0;
  private from: number[] = [];
  private to: number[] = [];
  private joints: number[] = [];
  private point: number[] = [];
  private yaw = 0;

  constructor(
    private readonly mujoco: MainModule,
    private readonly model: MjModel,
    private readonly data: MjData,
  ) {
    const id = (kind: "BODY" | "JOINT" | "SITE", name: string): number => {
      const found = idOf(mujoco, model, kind, name);
      if (found < 0) throw new Error(`The scene's robot has no ${name}.`);
      return found;
    };
    const ids = JOINTS.map((name) => id("JOINT", name));
    this.site = id("SITE", `${ROBOT}tcp`);
    this.base = id("BODY", `${ROBOT}link0`);
    this.qpos = ids.map((k): number => model.jnt_qposadr[k]);
    this.dof = ids.map((k): number => model.jnt_dofadr[k]);
    this.low = ids.map((k): number => model.jnt_range[2 * k]);
    this.high = ids.map((k): number => model.jnt_range[2 * k + 1]);
    this.every = Math.round(1 / HZ / model.opt.timestep);
    this.probe = new mujoco.MjData(model);
    this.jacp = new mujoco.DoubleBuffer(3 * model.nv);
    this.jacr = new mujoco.DoubleBuffer(3 * model.nv);
    this.reset();
  }

  delete(): void {
    this.jacp.delete();
    this.jacr.delete();
    this.probe.delete();
  }

  reset(): void {
    this.action = null;
    this.due = 0;
    this.joints = this.qpos.map((address): number => this.data.qpos[address]);
    this.from = this.to = this.joints;
    const tool = this.tool(this.joints);
    this.point = tool.position;
    this.yaw = Math.atan2(tool.rotation[3]!, tool.rotation[0]!);
  }

  /** Sets the action until the next call; null holds the servo commands. */
  drive(action: ArmAction | null): void {
    this.action = action;
  }

  /** Commands the servos for one step, interpolating linearly between two actions. */
  beforeStep(): void {
    if (this.due <= 0) {
      this.from = this.to;
      if (this.action) this.act(this.action);
      this.due = this.every;
    }
    this.due--;
    const share = 1 - this.due / this.every;
    this.to.forEach((to, k) => (this.data.ctrl[k] = this.from[k]! + share * (to - this.from[k]!)));
  }

  private act(action: ArmAction): void {
    const real = this.realTool();
    const ahead = this.point.map((p, i) => p + STEP * action[i]! - real.position[i]!);
    this.point = ahead.map((a, i) => clamp(real.position[i]! + clamp(a, -LEASH, LEASH), LOWEST[i]!, HIGHEST[i]!));
    const yaw = Math.atan2(real.rotation[3]!, real.rotation[0]!);
    const turned = wrap(this.yaw + TURN * action[3] - yaw);
    this.yaw = yaw + clamp(turned, -YAW_LEASH, YAW_LEASH);
    const before = this.joints;
    const after = this.ikStep(before);
    const turn = sub(after, before);
    const excess = Math.max(...turn.map((t, k) => Math.abs(t) / (SPEED[k]! / HZ)));
    this.joints = excess <= 1 ? after : add(before, turn.map((t) => t / excess));
    const lead = LEAD * HZ;
    this.to = this.joints.map((joint, k) => {
      return clamp(joint + lead * (joint - before[k]!), this.low[k]!, this.high[k]!);
    });
    this.data.ctrl[7] = (GRIPPER_OPEN * (action[4] + 1)) / 2;
  }

  /** Position and rotation (row-major) of the tool in the base frame, at the given joints. */
  private tool(joints: number[]): { position: number[]; rotation: number[] } {
    this.qpos.forEach((address, k) => (this.probe.qpos[address] = joints[k]!));
    this.mujoco.mj_kinematics(this.model, this.probe);
    this.mujoco.mj_comPos(this.model, this.probe);
    return this.toolOf(this.probe);
  }

  private realTool(): { position: number[]; rotation: number[] } {
    return this.toolOf(this.data);
  }

  private toolOf(data: MjData): { position: number[]; rotation: number[] } {
    const base = transpose([...(data.xmat as Float64Array).subarray(9 * this.base, 9 * this.base + 9)]);
    const origin = [...(data.xpos as Float64Array).subarray(3 * this.base, 3 * this.base + 3)];
    const at = [...(data.site_xpos as Float64Array).subarray(3 * this.site, 3 * this.site + 3)];
    const turn = [...(data.site_xmat as Float64Array).subarray(9 * this.site, 9 * this.site + 9)];
    return { position: times(base, sub(at, origin), 1), rotation: times(base, turn, 3) };
  }

  /** The tool's Jacobian in the base frame at the probe's joints: six rows of seven. */
  private jacobian(): number[][] {
    this.mujoco.mj_jacSite(this.model, this.probe, this.jacp, this.jacr, this.site);
    const base = transpose([...(this.probe.xmat as Float64Array).subarray(9 * this.base, 9 * this.base + 9)]);
    const rows: number[][] = [];
    for (const buffer of [this.jacp, this.jacr]) {
      const view = buffer.GetView() as Float64Array;
      const world = [0, 1, 2].map((i) => this.dof.map((dof) => view[i * this.model.nv + dof]!));
      for (let i = 0; i < 3; i++) {
        rows.push(this.dof.map((_, k) => dot(base.slice(3 * i, 3 * i + 3), world.map((row) => row[k]!))));
      }
    }
    return rows;
  }

  private ikStep(joints: number[]): number[] {
    const tool = this.tool(joints);
    const c = Math.cos(this.yaw);
    const s = Math.sin(this.yaw);
    const down = [c, s, 0, s, -c, 0, 0, 0, -1];
    const error = [...sub(this.point, tool.position), ...rotationVector(times(down, transpose(tool.rotation), 3))];
    const jacobian = this.jacobian();
    let rest = joints.map((q, k) => PULL * (HOME[k]! - q));
    const damping = 1e-5 + 1e-2 * Math.min(1, dot(error, error));
    let left = error;
    const free = joints.map(() => 1);
    let wanted = add(joints, dampedStep(jacobian, left, rest, damping));
    const low = this.low.map((l, k) => Math.min(l + MARGIN, joints[k]! + MAX_STEP));
    const high = this.high.map((h, k) => Math.max((k === 3 ? ELBOW : h - MARGIN), joints[k]! - MAX_STEP));
    const inside = (q: number[]): number[] => q.map((v, k) => clamp(v, low[k]!, high[k]!));
    for (let turn = 0; turn < 2; turn++) {
      const kept = inside(wanted);
      const out = wanted.map((w, k) => free[k]! * (w - kept[k]!) * (w - joints[k]!) > 0);
      if (!out.some(Boolean)) return kept;
      out.forEach((o, k) => o && (free[k] = 0));
      rest = rest.map((r, k) => (out[k] ? kept[k]! - joints[k]! : r));
      left = left.map((l, i) => l - dot(jacobian[i]!, rest.map((r, k) => (out[k] ? r : 0))));
      const held = jacobian.map((row) => row.map((v, k) => v * free[k]!));
      wanted = add(joints, dampedStep(held, left, rest, damping));
    }
    return inside(wanted);
  }
}

function dampedStep(jacobian: number[][], error: number[], rest: number[], damping: number): number[] {
  const square = jacobian.map((a, i) => jacobian.map((b, j) => dot(a, b) + (i === j ? damping : 0)));
  const wanted = error.map((e, i) => e - dot(jacobian[i]!, rest));
  const solved = solveSpd(square, wanted);
  const step = rest.map((r, k) => r + dot(solved, jacobian.map((row) => row[k]!)));
  const largest = Math.max(...step.map(Math.abs));
  return largest <= MAX_STEP ? step : step.map((s) => (s * MAX_STEP) / largest);
}

function wrap(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
