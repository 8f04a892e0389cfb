/** A recorded episode and the current time in it, with poses interpolated between its frames. */
import type { Episode } from "../data";
import type { ModelData } from "../physics/protocol";

export class Playback {
  /** Seconds since the start. */
  time = 0;
  private readonly quaternions: number[];

  constructor(
    readonly episode: Episode,
    model: ModelData,
  ) {
    this.quaternions = model.bodies.filter((body) => body.free).map((body) => body.qpos + 3);
  }

  get duration(): number {
    return (this.episode.frames - 1) / this.episode.hz;
  }

  get ended(): boolean {
    return this.time >= this.duration;
  }

  seek(seconds: number): void {
    this.time = Math.min(Math.max(seconds, 0), this.duration);
  }

  /** Returns the current qpos and position of the marker. */
  now(): { qpos: Float32Array; marker: Float32Array } {
    const { rows, nq, hz, frames } = this.episode;
    const width = nq + 3;
    const at = this.time * hz;
    const first = Math.min(Math.floor(at), frames - 2);
    const share = Math.min(at - first, 1);
    const a = rows.subarray(first * width, (first + 1) * width);
    const b = rows.subarray((first + 1) * width, (first + 2) * width);
    const row = a.map((value, k) => value + share * (b[k]! - value));
    for (const k of this.quaternions) blend(row, a, b, k, share);
    return { qpos: row.subarray(0, nq), marker: row.subarray(nq) };
  }
}

/** Writes the normalised linear interpolation of two quaternions at `k`, along the shorter arc. */
function blend(row: Float32Array, a: Float32Array, b: Float32Array, k: number, share: number): void {
  let dot = 0;
  for (let i = 0; i < 4; i++) dot += a[k + i]! * b[k + i]!;
  const sign = dot < 0 ? -1 : 1;
  let length = 0;
  for (let i = 0; i < 4; i++) {
    row[k + i] = (1 - share) * a[k + i]! + share * sign * b[k + i]!;
    length += row[k + i]! ** 2;
  }
  for (let i = 0; i < 4; i++) row[k + i]! /= Math.sqrt(length) || 1;
}
