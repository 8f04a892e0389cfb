/** The three.js objects of a model: geometries, materials, and a group per body. */
import * as THREE from "three";
import { mergeVertices } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { GEOM, type GeomData, type MeshData, type ModelData, type TextureData } from "../physics/protocol";

/** MuJoCo's group of collision parts in bundles; visual geoms are in the groups below. */
export const COLLISION_GROUP = 3;

/** Distinct colours of collision parts, in order. */
const PART_COLORS = [0x3b82f6, 0xf59e0b, 0x10b981, 0xec4899, 0x8b5cf6, 0x14b8a6, 0xef4444, 0x84cc16];

/** The geom that marks an episode's goal; it is below the floor if there is none. */
const MARKER = "marker/goal";
const MARKED = 0.6;

/** Invisible changes of a pose, metres or quaternion components. */
const STILL = 2e-5;

export interface BuiltBody {
  group: THREE.Group;
  visual: THREE.Mesh[];
  collision: THREE.Mesh[];
}

export class BuiltModel {
  readonly root = new THREE.Group();
  readonly bodies: BuiltBody[];
  private placed: Float32Array = new Float32Array(0);
  private readonly owned: { dispose(): void }[] = [];

  constructor(
    readonly data: ModelData,
    anisotropy: number,
  ) {
    const textures = data.textures.map((texture) => this.own(textureOf(texture, anisotropy)));
    const materials = data.materials.map((material) => {
      const texture = material.texture >= 0 ? textures[material.texture] : undefined;
      return this.own(surface(material.rgba, material.shininess, texture));
    });
    const geometries = data.meshes.map((mesh) => this.own(geometryOf(mesh)));
    this.bodies = data.bodies.map(() => ({ group: new THREE.Group(), visual: [], collision: [] }));
    for (const geom of data.geoms) {
      const drawn = this.drawn(geom, geometries, materials);
      const body = this.bodies[geom.body]!;
      if (!drawn) continue;
      drawn.userData = { body: geom.body };
      (geom.group >= COLLISION_GROUP ? body.collision : body.visual).push(drawn);
      body.group.add(drawn);
    }
    for (const [k, body] of this.bodies.entries()) {
      body.collision.forEach((part, i) => {
        part.material = this.own(partMaterial(PART_COLORS[(k + i) % PART_COLORS.length]!));
        part.visible = false;
      });
      this.root.add(body.group);
    }
  }

  /** Moves every body to its pose in a frame; returns whether any moved visibly. */
  place(poses: Float32Array): boolean {
    if (this.placed.length === poses.length && poses.every((v, k) => Math.abs(v - this.placed[k]!) < STILL)) return false;
    this.placed = poses;
    this.bodies.forEach(({ group }, k) => {
      const p = 7 * k;
      group.position.set(poses[p]!, poses[p + 1]!, poses[p + 2]!);
      group.quaternion.set(poses[p + 4]!, poses[p + 5]!, poses[p + 6]!, poses[p + 3]!);
    });
    return true;
  }

  /** Makes the next frame update every body, whatever its previous pose. */
  forget(): void {
    this.placed = new Float32Array(0);
  }

  /** Shows the convex collision parts instead of the visual geoms. */
  showParts(on: boolean): void {
    for (const { visual, collision } of this.bodies) {
      for (const part of collision) part.visible = on;
      for (const mesh of visual) mesh.visible = !on || collision.length === 0;
    }
  }

  dispose(): void {
    this.root.removeFromParent();
    for (const thing of this.owned) thing.dispose();
  }

  private own<T extends { dispose(): void }>(thing: T): T {
    this.owned.push(thing);
    return thing;
  }

  private drawn(
    geom: GeomData,
    geometries: THREE.BufferGeometry[],
    materials: THREE.MeshStandardMaterial[],
  ): THREE.Mesh | null {
    const shared = geom.mesh >= 0 && geom.type === GEOM.mesh ? geometries[geom.mesh] : undefined;
    const shape = shared ?? primitive(geom);
    if (!shape) return null;
    if (!shared) this.own(shape);
    const own = geom.material >= 0 ? materials[geom.material] : undefined;
    if (!own && geom.rgba[3] === 0 && geom.group < COLLISION_GROUP && geom.name === "") return null;
    const rgba = geom.name === MARKER ? [...geom.rgba.slice(0, 3), MARKED] : geom.rgba;
    const mesh = new THREE.Mesh(shape, own ?? this.own(surface(rgba, 0.3)));
    mesh.position.set(...geom.position);
    mesh.quaternion.set(geom.quaternion[1], geom.quaternion[2], geom.quaternion[3], geom.quaternion[0]);
    const clear = (mesh.material as THREE.Material).transparent;
    mesh.castShadow = geom.group < COLLISION_GROUP && !clear;
    mesh.receiveShadow = !clear;
    return mesh;
  }
}

function textureOf({ width, height, pixels }: TextureData, anisotropy: number): THREE.DataTexture {
  const texture = new THREE.DataTexture(pixels as Uint8Array<ArrayBuffer>, width, height);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}

function surface(rgba: number[], shininess: number, map?: THREE.Texture): THREE.MeshStandardMaterial {
  const color = new THREE.Color().setRGB(rgba[0]!, rgba[1]!, rgba[2]!, THREE.SRGBColorSpace);
  const opacity = rgba[3]!;
  return new THREE.MeshStandardMaterial({
    color,
    map: map ?? null,
    roughness: Math.min(Math.max(0.95 - shininess, 0.15), 1),
    metalness: 0,
    transparent: opacity < 1,
    opacity,
    depthWrite: opacity > 0.9,
    side: opacity < 1 ? THREE.DoubleSide : THREE.FrontSide,
    shadowSide: THREE.DoubleSide,
  });
}

function partMaterial(color: number): THREE.MeshStandardMaterial {
  return new THREE.MeshStandardMaterial({ color, roughness: 0.8, flatShading: true });
}

function geometryOf({ positions, normals, uvs }: MeshData): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
  if (uvs) geometry.setAttribute("uv", new THREE.BufferAttribute(uvs, 2));
  return mergeVertices(geometry, 1e-6);
}

/** The shape of a geom that is not a mesh, with MuJoCo's z axis; null for others. */
function primitive({ type, size }: GeomData): THREE.BufferGeometry | null {
  const upright = <T extends THREE.BufferGeometry>(shape: T): T => shape.rotateX(Math.PI / 2);
  switch (type) {
    case GEOM.box:
      return new THREE.BoxGeometry(2 * size[0], 2 * size[1], 2 * size[2]);
    case GEOM.sphere:
      return new THREE.SphereGeometry(size[0], 32, 20);
    case GEOM.ellipsoid:
      return new THREE.SphereGeometry(1, 32, 20).scale(...size);
    case GEOM.cylinder:
      return upright(new THREE.CylinderGeometry(size[0], size[0], 2 * size[1], 40));
    case GEOM.capsule:
      return upright(new THREE.CapsuleGeometry(size[0], 2 * size[1], 10, 24));
    default:
      return null;
  }
}
