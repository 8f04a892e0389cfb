/** Names of elements of a model, and their ids by name. */
import type { MainModule, MjModel } from "@mujoco/mujoco";

/** Prefix of the robot's names. */
export const ROBOT = "panda/";

type Kind = "BODY" | "CAMERA" | "GEOM" | "JOINT" | "KEY" | "SITE";

/** MuJoCo's number of an object type; its declared types omit the values of enumerations. */
function typeOf(mujoco: MainModule, kind: Kind): number {
  return (mujoco.mjtObj as unknown as Record<string, { value: number }>)[`mjOBJ_${kind}`]!.value;
}

/** The name of the `k`-th element of a type, "" if it has none. */
export function nameOf(mujoco: MainModule, model: MjModel, kind: Kind, k: number): string {
  return mujoco.mj_id2name(model, typeOf(mujoco, kind), k) ?? "";
}

/** The id of an element by name, -1 if there is none. */
export function idOf(mujoco: MainModule, model: MjModel, kind: Kind, name: string): number {
  return mujoco.mj_name2id(model, typeOf(mujoco, kind), name);
}
