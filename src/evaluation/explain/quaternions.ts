import { influencesOf, type Skin } from '../../core/skin.ts';
import type { Quaternion, Vector3 } from '../../posing/ik/problem.ts';
import { dotFour } from '../../skinning/blend-quaternions.ts';
import { heaviestEntry } from '../../skinning/heaviest-entry.ts';
import type { Evaluation } from '../evaluation.ts';
import type { ExplainedStep } from './explanation.ts';

/** The names of the columns of a quaternion. */
const quaternionColumns: readonly string[] = ['x', 'y', 'z', 'w'];

/** Below this length a sum has no direction, and linear blend moves the vertex. */
export const shortest = 1e-6;

/** An influence as methods that blend rotations use it. */
export interface SignedInfluence {
  readonly entry: number;
  /** At least 0, and negative if its rotation points away from that of the heaviest influence. */
  readonly weight: number;
}

/**
 * The influences of a point with the signs that the kernel gives them. The signs are read from the
 * palette in its own precision, because a rotation at right angles to the other one decides by its
 * last bit.
 *
 * @param skin has the weights as the method uses them
 * @param rotationAt where the rotation stands in an entry of the palette, in numbers
 */
export function signedInfluences(
  { palette, skin: { paletteJoint } }: Evaluation,
  skin: Skin,
  point: number,
  rotationAt: number,
): readonly SignedInfluence[] {
  const stride = palette.length / paletteJoint.length;
  const rotationOf = (entry: number): Float32Array =>
    palette.subarray(entry * stride + rotationAt, entry * stride + rotationAt + 4);
  const [px, py, pz, pw] = rotationOf(heaviestEntry(skin, point));
  return influencesOf(skin, point).map(({ entry, weight }) => {
    const [x, y, z, w] = rotationOf(entry);
    const sign = dotFour(px!, py!, pz!, pw!, x!, y!, z!, w!) < 0 ? -1 : 1;
    return { entry, weight: sign * Math.max(0, weight) };
  });
}

/** The table of what influences add to a sum of quaternions. */
export function sumStep(
  title: string,
  signed: readonly SignedInfluence[],
  terms: readonly Quaternion[],
): ExplainedStep {
  const rows = signed.map(({ entry }, i) => ({ of: entry, values: terms[i]! }));
  return { title, columns: quaternionColumns, rows, total: sumOfQuaternions(terms) };
}

export function sumOfQuaternions(quaternions: readonly Quaternion[]): Quaternion {
  const sum = (i: number): number => quaternions.reduce((total, each) => total + each[i]!, 0);
  return [sum(0), sum(1), sum(2), sum(3)];
}

export function scaledQuaternion([x, y, z, w]: Quaternion, by: number): Quaternion {
  return [x * by, y * by, z * by, w * by];
}

/** Turns a vector by a unit quaternion. */
export function turned([x, y, z, w]: Quaternion, [px, py, pz]: Vector3): Vector3 {
  const ax = y * pz - z * py + w * px;
  const ay = z * px - x * pz + w * py;
  const az = x * py - y * px + w * pz;
  return [px + 2 * (y * az - z * ay), py + 2 * (z * ax - x * az), pz + 2 * (x * ay - y * ax)];
}

/** The angle of a unit quaternion in degrees, from 0 to 180, and its axis. */
export function axisAndAngle([x, y, z, w]: Quaternion): readonly [Vector3, number] {
  const length = Math.hypot(x, y, z);
  const side = w < 0 ? -1 : 1;
  const scale = length > 0 ? side / length : 0;
  return [[x * scale, y * scale, z * scale], (360 / Math.PI) * Math.atan2(length, side * w)];
}
