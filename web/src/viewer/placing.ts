/** A thing that a person moves or turns on the table, before the change is made for good. */
import * as THREE from "three";

export interface Move {
  /** Where its centre is to be: metres from the table's, +x right and +y away; null where it is. */
  to: [number, number] | null;
  /** Degrees it was turned, counter-clockwise seen from above. */
  turn: number;
}

/** Moves smaller than these are none: metres, degrees. */
const LEAST_MOVE = 0.002;
const LEAST_TURN = 1;

export class Placing {
  private readonly from: THREE.Vector3;
  private readonly facing: THREE.Quaternion;
  private angle = 0;

  /** @param held - where the thing is held, in the world. */
  constructor(
    private readonly group: THREE.Object3D,
    private readonly held: THREE.Vector3,
  ) {
    this.from = group.position.clone();
    this.facing = group.quaternion.clone();
  }

  /** Follows the pointer to a point as high as where it is held; `turning` turns in place. */
  drag(target: THREE.Vector3, turning: boolean): void {
    if (turning) {
      const bearing = (at: THREE.Vector3): number => Math.atan2(at.y - this.from.y, at.x - this.from.x);
      this.turn(bearing(target) - bearing(this.held));
    } else {
      this.group.position.set(this.from.x + target.x - this.held.x, this.from.y + target.y - this.held.y, this.from.z);
    }
  }

  turn(angle: number): void {
    this.angle = angle;
    const about = new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0, 1), angle);
    this.group.quaternion.copy(about.multiply(this.facing));
  }

  /** Returns what was asked for; null if the thing is where it was. */
  end(): Move | null {
    const { x, y } = this.group.position;
    const degrees = (((this.angle * 180) / Math.PI + 540) % 360) - 180;
    const moved = Math.hypot(x - this.from.x, y - this.from.y) >= LEAST_MOVE;
    if (!moved && Math.abs(degrees) < LEAST_TURN) return null;
    const round = (v: number): number => Math.round(v * 1000) / 1000; // millimetres
    return { to: moved ? [round(x), round(y)] : null, turn: Math.round(degrees) };
  }

  /** Puts the thing back where it was. */
  undo(): void {
    this.group.position.copy(this.from);
    this.group.quaternion.copy(this.facing);
  }
}
