/** The drawn parts of a compiled model: geoms, meshes, textures, cameras, bodies. */
import type { MainModule, MjModel } from "@mujoco/mujoco";
import { nameOf, ROBOT } from "./names";
import type {
  BodyData,
  CameraData,
  GeomData,
  MaterialData,
  MeshData,
  ModelData,
  Quaternion,
  TextureData,
  Vector,
} from "./protocol";

type Numbers = ArrayLike<number>;

const vector = (from: Numbers, k: number): Vector => [from[3 * k]!, from[3 * k + 1]!, from[3 * k + 2]!];

const quaternion = (from: Numbers, k: number): Quaternion => [
  from[4 * k]!,
  from[4 * k + 1]!,
  from[4 * k + 2]!,
  from[4 * k + 3]!,
];

const four = (from: Numbers, k: number): number[] => Array.from({ length: 4 }, (_, i) => from[4 * k + i]!);

export function describe(mujoco: MainModule, model: MjModel): ModelData {
  const count = (n: number): number[] => Array.from({ length: n }, (_, k) => k);
  const bodies = count(model.nbody).map((k): BodyData => bodyOf(model, k, nameOf(mujoco, model, "BODY", k)));
  return {
    bodies,
    geoms: count(model.ngeom).map((k) => geomOf(model, k, nameOf(mujoco, model, "GEOM", k))),
    meshes: count(model.nmesh).map((k) => meshOf(model, k)),
    materials: count(model.nmat).map((k) => materialOf(model, k)),
    textures: count(model.ntex).map((k) => textureOf(model, k)),
    cameras: count(model.ncam).map((k) => cameraOf(model, k, nameOf(mujoco, model, "CAMERA", k))),
    nq: model.nq,
    timestep: model.opt.timestep,
    arm: bodies.some((body) => body.name.startsWith(ROBOT)),
  };
}

function bodyOf(model: MjModel, k: number, name: string): BodyData {
  const joint: number = model.body_jntadr[k];
  const free = joint >= 0 && model.jnt_type[joint] === 0;
  return {
    name,
    free,
    qpos: free ? model.jnt_qposadr[joint] : -1,
    moves: model.body_weldid[k] !== 0,
  };
}

function geomOf(model: MjModel, k: number, name: string): GeomData {
  return {
    name,
    body: model.geom_bodyid[k],
    type: model.geom_type[k],
    size: vector(model.geom_size, k),
    position: vector(model.geom_pos, k),
    quaternion: quaternion(model.geom_quat, k),
    rgba: four(model.geom_rgba, k),
    group: model.geom_group[k],
    mesh: model.geom_dataid[k],
    material: model.geom_matid[k],
  };
}

/** Gathers `width` numbers for each corner in `faces`, from the row `first` on. */
function gather(from: Numbers, first: number, faces: Numbers, start: number, n: number, width: number): Float32Array {
  const out = new Float32Array(n * width);
  for (let k = 0; k < n; k++) {
    const row = first + faces[start + k]!;
    for (let i = 0; i < width; i++) out[k * width + i] = from[row * width + i]!;
  }
  return out;
}

function meshOf(model: MjModel, k: number): MeshData {
  const start = 3 * model.mesh_faceadr[k];
  const corners = 3 * model.mesh_facenum[k];
  const uv: number = model.mesh_texcoordadr[k];
  return {
    positions: gather(model.mesh_vert, model.mesh_vertadr[k], model.mesh_face, start, corners, 3),
    normals: gather(model.mesh_normal, model.mesh_normaladr[k], model.mesh_facenormal, start, corners, 3),
    uvs: uv < 0 ? null : gather(model.mesh_texcoord, uv, model.mesh_facetexcoord, start, corners, 2),
  };
}

function materialOf(model: MjModel, k: number): MaterialData {
  const roles = model.mat_texid.length / Math.max(model.nmat, 1);
  const own = Array.from({ length: roles }, (_, i): number => model.mat_texid[k * roles + i]);
  return {
    rgba: four(model.mat_rgba, k),
    texture: own.find((id) => id >= 0) ?? -1,
    shininess: model.mat_shininess[k],
  };
}

function textureOf(model: MjModel, k: number): TextureData {
  const width: number = model.tex_width[k];
  const height: number = model.tex_height[k];
  const channels: number = model.tex_nchannel[k];
  const start: number = model.tex_adr[k];
  const data: Numbers = model.tex_data;
  const pixels = new Uint8Array(4 * width * height);
  for (let p = 0; p < width * height; p++) {
    for (let c = 0; c < 4; c++) {
      pixels[4 * p + c] = c < channels ? data[start + channels * p + c]! : 255;
    }
  }
  return { width, height, pixels };
}

function cameraOf(model: MjModel, k: number, name: string): CameraData {
  return {
    name,
    position: vector(model.cam_pos, k),
    quaternion: quaternion(model.cam_quat, k),
    fovy: model.cam_fovy[k],
  };
}
