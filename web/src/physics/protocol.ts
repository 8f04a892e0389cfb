/**
 * Messages between the page and its physics worker.
 *
 * Units are metres, kilograms, radians and seconds; quaternions are wxyz, as in MuJoCo. The world
 * frame is the bundle's: +z up, +y away from the viewer of the picture.
 */

export type Vector = [number, number, number];
export type Quaternion = [number, number, number, number];

/** Values of MuJoCo's `mjtGeom` for the geom types in scenes. */
export const GEOM = {
  plane: 0,
  sphere: 2,
  capsule: 3,
  ellipsoid: 4,
  cylinder: 5,
  box: 6,
  mesh: 7,
} as const;

/** A mesh of triangles without shared corners, so that each corner has its own normal and uv. */
export interface MeshData {
  positions: Float32Array;
  normals: Float32Array;
  uvs: Float32Array | null;
}

/** An image of 8-bit RGBA; its first row is v = 0. */
export interface TextureData {
  width: number;
  height: number;
  pixels: Uint8Array;
}

export interface MaterialData {
  rgba: number[];
  texture: number;
  shininess: number;
}

export interface GeomData {
  name: string;
  body: number;
  type: number;
  size: Vector;
  position: Vector;
  quaternion: Quaternion;
  rgba: number[];
  group: number;
  mesh: number;
  material: number;
}

export interface BodyData {
  name: string;
  /** Whether the body is free, as the objects on a table are. */
  free: boolean;
  /** Address of a free body in qpos. */
  qpos: number;
  /** Whether the body can move, i.e. is not welded to the world. */
  moves: boolean;
}

export interface CameraData {
  name: string;
  position: Vector;
  quaternion: Quaternion;
  /** Vertical field of view, degrees. */
  fovy: number;
}

export interface ModelData {
  bodies: BodyData[];
  geoms: GeomData[];
  meshes: MeshData[];
  materials: MaterialData[];
  textures: TextureData[];
  cameras: CameraData[];
  nq: number;
  timestep: number;
  /** Whether the Panda stands at the table. */
  arm: boolean;
}

/** The drawn state at one instant. */
export interface Frame {
  /** Simulated time, seconds. */
  time: number;
  running: boolean;
  /** Position and quaternion of every body, seven numbers each. */
  poses: Float32Array;
  /** Centre of mass of every body, three numbers each; null unless displayed. */
  centres: Float32Array | null;
  /** Position, normal and force (newtons) of every contact, seven numbers each; null unless displayed. */
  contacts: Float32Array | null;
}

/** A person's command to the arm: the action of `ee_delta`, each entry in [-1, 1]. */
export type ArmAction = [number, number, number, number, number];

/** A candidate pose of a body. */
export interface Placed {
  body: number;
  position: Vector;
  quaternion: Quaternion;
}

export type Command =
  | { kind: "load"; module: WebAssembly.Module; xml: string; files: [string, Uint8Array][]; start: string }
  | { kind: "run"; running: boolean }
  | { kind: "step"; steps: number }
  | { kind: "reset" }
  | { kind: "show"; centres: boolean; contacts: boolean }
  | { kind: "drag"; body: number; grip: Vector; target: Vector }
  | { kind: "release" }
  | { kind: "pose"; qpos: Float32Array; marker: Float32Array | null }
  | { kind: "arm"; action: ArmAction | null }
  | { kind: "state" }
  | { kind: "overlaps"; placed: Placed[] };

export type Request = Command & { id: number };

export interface State {
  time: number;
  qpos: number[];
  qvel: number[];
  ctrl: number[];
  contacts: number;
}

/** Responses by request: a model to "load", a state to "state", bodies to "overlaps". */
export type Answer = ModelData | State | number[] | null;

export type Reply =
  | { kind: "done"; id: number; value: Answer }
  | { kind: "failed"; id: number; message: string }
  | { kind: "frame"; frame: Frame };
