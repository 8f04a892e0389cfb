/** Overlays on the scene: centres of mass, contacts, and the line along which an object is pulled. */
import * as THREE from "three";

const MOST_CONTACTS = 400;
const NEWTON = 0.03; // drawn length of a newton, metres
const LONGEST = 0.15;
const FRAME = 0x2563eb;
const BLOCKED = 0xdc2626;

export class Marks {
  readonly root = new THREE.Group();
  private readonly centres: THREE.InstancedMesh;
  private readonly spots: THREE.InstancedMesh;
  private readonly forces: THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial>;
  private frame: THREE.BoxHelper | null = null;
  private readonly rope: THREE.Line<THREE.BufferGeometry, THREE.LineBasicMaterial>;

  constructor(private readonly shownBodies: number[]) {
    const over = { depthTest: false, transparent: true };
    this.centres = new THREE.InstancedMesh(
      new THREE.SphereGeometry(0.006, 16, 12),
      new THREE.MeshBasicMaterial({ color: 0xd97706, ...over }),
      Math.max(shownBodies.length, 1),
    );
    this.spots = new THREE.InstancedMesh(
      new THREE.SphereGeometry(0.003, 10, 8),
      new THREE.MeshBasicMaterial({ color: 0xdc2626, ...over }),
      MOST_CONTACTS,
    );
    this.forces = new THREE.LineSegments(lines(2 * MOST_CONTACTS), new THREE.LineBasicMaterial({ color: 0xdc2626, ...over }));
    this.rope = new THREE.Line(lines(2), new THREE.LineBasicMaterial({ color: 0x2563eb, ...over }));
    for (const mark of [this.centres, this.spots, this.forces, this.rope]) {
      mark.visible = false;
      mark.frustumCulled = false;
      mark.renderOrder = 10;
      this.root.add(mark);
    }
  }

  /** Whether centres of mass or contacts are shown. */
  get shown(): boolean {
    return this.centres.visible || this.spots.visible;
  }

  showCentres(positions: Float32Array | null): void {
    this.centres.visible = positions !== null;
    if (!positions) return;
    const place = new THREE.Matrix4();
    this.shownBodies.forEach((body, k) => {
      place.makeTranslation(positions[3 * body]!, positions[3 * body + 1]!, positions[3 * body + 2]!);
      this.centres.setMatrixAt(k, place);
    });
    this.centres.count = this.shownBodies.length;
    this.centres.instanceMatrix.needsUpdate = true;
  }

  showContacts(rows: Float32Array | null): void {
    this.spots.visible = this.forces.visible = rows !== null;
    if (!rows) return;
    const count = Math.min(rows.length / 7, MOST_CONTACTS);
    const ends = this.forces.geometry.getAttribute("position") as THREE.BufferAttribute;
    const place = new THREE.Matrix4();
    for (let k = 0; k < count; k++) {
      const [x, y, z, nx, ny, nz, force] = rows.subarray(7 * k, 7 * k + 7) as unknown as number[];
      const long = Math.min(force! * NEWTON, LONGEST);
      this.spots.setMatrixAt(k, place.makeTranslation(x!, y!, z!));
      ends.setXYZ(2 * k, x!, y!, z!);
      ends.setXYZ(2 * k + 1, x! + nx! * long, y! + ny! * long, z! + nz! * long);
    }
    this.spots.count = count;
    this.spots.instanceMatrix.needsUpdate = true;
    ends.needsUpdate = true;
    this.forces.geometry.setDrawRange(0, 2 * count);
  }

  /** Frames the selected object; null for none. */
  select(thing: THREE.Object3D | null): void {
    this.frame?.removeFromParent();
    this.frame?.dispose();
    this.frame = null;
    if (!thing) return;
    this.frame = new THREE.BoxHelper(thing, FRAME);
    this.frame.renderOrder = 10;
    this.root.add(this.frame);
  }

  /** Moves the frame with its object. */
  follow(): void {
    this.frame?.update();
  }

  /** Draws the frame in the colour of an invalid place, or as usual. */
  warn(blocked: boolean): void {
    (this.frame?.material as THREE.LineBasicMaterial | undefined)?.color.set(blocked ? BLOCKED : FRAME);
  }

  showRope(from: THREE.Vector3 | null, to: THREE.Vector3 | null): void {
    this.rope.visible = from !== null && to !== null;
    if (!from || !to) return;
    const ends = this.rope.geometry.getAttribute("position") as THREE.BufferAttribute;
    ends.setXYZ(0, from.x, from.y, from.z);
    ends.setXYZ(1, to.x, to.y, to.z);
    ends.needsUpdate = true;
  }

  dispose(): void {
    this.select(null);
    this.root.removeFromParent();
    for (const mark of [this.centres, this.spots, this.forces, this.rope]) {
      mark.geometry.dispose();
      (mark.material as THREE.Material).dispose();
    }
    this.centres.dispose();
    this.spots.dispose();
  }
}

function lines(points: number): THREE.BufferGeometry {
  return new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * points), 3));
}
