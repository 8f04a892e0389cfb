/** Validity of an object's place while a person moves the object. */
import * as THREE from "three";
import type { Placed } from "../physics/protocol";
import type { BuiltModel } from "./meshes";

/** Objects on a table start this far above its top, metres. */
const GAP = 2e-4;
/** Corners this far below the highest one still belong to the table's top, metres. */
const LEVEL = 2e-3;

export class PlaceCheck {
  /** The table's top seen from above: a convex outline, counter-clockwise. */
  private readonly top: THREE.Vector2[];
  private readonly height: number;
  /** Whether the current place still has to be checked. */
  private fresh = false;
  /** Whether the result is to be reported. */
  private wanted = false;
  private asking = false;

  /**
   * @param bodies - the moving bodies: the object, then those that it carries.
   * @param falls - whether it moves from another object down to the table.
   * @param overlaps - returns the bodies that others would overlap elsewhere.
   * @param told - called with the reason why the object cannot stand there; null if it can.
   */
  constructor(
    private readonly model: BuiltModel,
    private readonly bodies: number[],
    readonly falls: boolean,
    private readonly overlaps: (placed: Placed[]) => Promise<number[]>,
    private readonly told: (why: string | null) => void,
  ) {
    const fixed = model.data.bodies.flatMap((body, k) => (body.moves ? [] : corners(model, k)));
    this.height = Math.max(...fixed.map(({ z }) => z));
    this.top = outline(fixed.filter(({ z }) => z > this.height - LEVEL));
  }

  /** Checks the current place; during a check, the most recent place is queued. */
  look(): void {
    this.fresh = this.wanted = true;
    if (!this.asking) void this.work();
  }

  /** Forgets the place: its result is no longer reported. */
  forget(): void {
    this.fresh = this.wanted = false;
    this.told(null);
  }

  private async work(): Promise<void> {
    this.asking = true;
    try {
      while (this.fresh) {
        this.fresh = false;
        const why = await this.find();
        if (this.wanted) this.told(why);
      }
    } catch (error) {
      console.warn("place:", error); // the user gets the error when requesting the place
      this.forget();
    } finally {
      this.asking = false;
    }
  }

  private async find(): Promise<string | null> {
    const points = corners(this.model, this.bodies[0]!);
    const low = Math.min(...points.map(({ z }) => z));
    const high = Math.max(...points.map(({ z }) => z));
    const base = points.filter(({ z }) => z <= low + 0.1 * (high - low));
    if (!base.every((point) => inside(this.top, point))) return "off the table";
    const down = this.falls && this.top.length ? low - this.height - GAP : 0;
    const found = await this.overlaps(this.bodies.map((body) => placed(body, this.model.bodies[body]!.group, down)));
    const names = found.map((body) => this.model.data.bodies[body]!.name);
    return names.length ? `${names.join(", ")} in the way` : null;
  }
}

function placed(body: number, { position, quaternion }: THREE.Object3D, down: number): Placed {
  const { x, y, z, w } = quaternion;
  return { body, position: [position.x, position.y, position.z - down], quaternion: [w, x, y, z] };
}

/** The corners of a body's collision parts in the world. */
function corners(model: BuiltModel, body: number): THREE.Vector3[] {
  return model.bodies[body]!.collision.flatMap((part) => {
    part.updateWorldMatrix(true, false);
    const at = part.geometry.getAttribute("position");
    return Array.from({ length: at.count }, (_, k) => new THREE.Vector3().fromBufferAttribute(at, k).applyMatrix4(part.matrixWorld));
  });
}

const side = (a: THREE.Vector2, b: THREE.Vector2, c: { x: number; y: number }): number =>
  (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);

/** The convex hull of points seen from above, counter-clockwise. */
function outline(points: THREE.Vector3[]): THREE.Vector2[] {
  const sorted = points.map(({ x, y }) => new THREE.Vector2(x, y)).sort((a, b) => a.x - b.x || a.y - b.y);
  const chain = (row: THREE.Vector2[]): THREE.Vector2[] => {
    const kept: THREE.Vector2[] = [];
    for (const point of row) {
      while (kept.length > 1 && side(kept.at(-2)!, kept.at(-1)!, point) <= 0) kept.pop();
      kept.push(point);
    }
    return kept.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

function inside(hull: THREE.Vector2[], point: { x: number; y: number }): boolean {
  return hull.every((corner, k) => side(corner, hull[(k + 1) % hull.length]!, point) >= 0);
}
