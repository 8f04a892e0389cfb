/** An object that a person moves or rotates on the table, before the change is saved. */
import * as THREE from "three";

export interface Move {
  /** Target of its centre: metres from the table's, +x right and +y away; null if unchanged. */
  to: [number, number] | null;
  /** Rotation in degrees, counter-clockwise seen from above. */
  turn: number;
}

/** Smaller moves are ignored: metres, degrees. */
const LEAST_MOVE = 0.002;
const LEAST_TURN = 1;

const UP = new THREE.Vector3(0, 0, 1);

/** The drawn group of an object, and its pose before the move. */
interface Part {
  group: THREE.Object3D;
  from: THREE.Vector3;
  facing: THREE.Quaternion;
}

export class Placing {
  /** The object, then the objects on or in it, which move along. */
  private readonly parts: Part[];
  private readonly from: THREE.Vector3;
  private readonly moved = new THREE.Vector3();
  private angle = 0;

  /**
   * @param groups - the object, then the objects on or in it.
   * @param held - the held point, in the world.
   */
  constructor(
    groups: THREE.Object3D[],
    private readonly held: THREE.Vector3,
  ) {
    this.parts = groups.map((group) => ({ group, from: group.position.clone(), facing: group.quaternion.clone() }));
    this.from = this.parts[0]!.from;
  }

  /** Follows the pointer to a point at the height of the held point; `turning` rotates in place. */
  drag(target: THREE.Vector3, turning: boolean): void {
    if (turning) {
      const bearing = (at: THREE.Vector3): number => Math.atan2(at.y - this.from.y, at.x - this.from.x);
      this.angle = bearing(target) - bearing(this.held);
    } else {
      this.moved.set(target.x - this.held.x, target.y - this.held.y, 0);
    }
    this.show();
  }

  private show(): void {
    const about = new THREE.Quaternion().setFromAxisAngle(UP, this.angle);
    for (const { group, from, facing } of this.parts) {
      group.position.copy(from).sub(this.from).applyQuaternion(about).add(this.from).add(this.moved);
      group.quaternion.copy(about).multiply(facing);
    }
  }

  /** Returns the requested change; null if the object has not moved. */
  end(): Move | null {
    const degrees = (((this.angle * 180) / Math.PI + 540) % 360) - 180;
    const moved = this.moved.length() >= LEAST_MOVE;
    if (!moved && Math.abs(degrees) < LEAST_TURN) return null;
    const round = (v: number): number => Math.round(v * 1000) / 1000; // millimetres
    const to = this.from.clone().add(this.moved);
    return { to: moved ? [round(to.x), round(to.y)] : null, turn: Math.round(degrees) };
  }

  /** Puts everything back where it was. */
  undo(): void {
    this.moved.set(0, 0, 0);
    this.angle = 0;
    this.show();
  }
}
