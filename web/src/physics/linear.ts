/** Linear algebra for the arm's kinematics; matrices are row-major. */

export const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);

export const add = (a: number[], b: number[]): number[] => a.map((v, k) => v + b[k]!);

export const sub = (a: number[], b: number[]): number[] => a.map((v, k) => v - b[k]!);

export const dot = (a: number[], b: number[]): number => a.reduce((sum, v, k) => sum + v * b[k]!, 0);

/** The transpose of a 3x3 matrix. */
export const transpose = (m: number[]): number[] => [0, 3, 6, 1, 4, 7, 2, 5, 8].map((k) => m[k]!);

/** The product of a 3x3 matrix and one of three rows and `columns` columns. */
export function times(a: number[], b: number[], columns: number): number[] {
  const out: number[] = [];
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < columns; j++) {
      out.push(a[3 * i]! * b[j]! + a[3 * i + 1]! * b[columns + j]! + a[3 * i + 2]! * b[2 * columns + j]!);
    }
  }
  return out;
}

/** The axis of a rotation matrix times its angle, in [0, pi]. */
export function rotationVector(r: number[]): number[] {
  const skew = [r[7]! - r[5]!, r[2]! - r[6]!, r[3]! - r[1]!];
  const sine = Math.hypot(...skew) / 2;
  const cosine = (r[0]! + r[4]! + r[8]! - 1) / 2;
  const angle = Math.atan2(sine, cosine);
  if (sine > 1e-7) return skew.map((v) => (v * angle) / (2 * sine));
  if (cosine > 0) return skew.map((v) => v / 2);
  const axis = [0, 4, 8].map((k) => Math.sqrt(Math.max((r[k]! + 1) / 2, 0)));
  const largest = axis.indexOf(Math.max(...axis));
  const row = r.slice(3 * largest, 3 * largest + 3);
  return axis.map((v, k) => angle * v * (k === largest || row[k]! >= 0 ? 1 : -1));
}

/** Solves `a x = b` for a symmetric positive definite `a` by Cholesky decomposition. */
export function solveSpd(a: number[][], b: number[]): number[] {
  const n = b.length;
  const l = a.map((row) => row.slice());
  for (let j = 0; j < n; j++) {
    for (let i = j; i < n; i++) {
      let sum = l[i]![j]!;
      for (let k = 0; k < j; k++) sum -= l[i]![k]! * l[j]![k]!;
      l[i]![j] = i === j ? Math.sqrt(Math.max(sum, 1e-300)) : sum / l[j]![j]!;
    }
  }
  const x = b.slice();
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < i; k++) x[i] = x[i]! - l[i]![k]! * x[k]!;
    x[i] = x[i]! / l[i]![i]!;
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) x[i] = x[i]! - l[k]![i]! * x[k]!;
    x[i] = x[i]! / l[i]![i]!;
  }
  return x;
}
