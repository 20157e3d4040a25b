import { mat4 } from 'gl-matrix';
import { extractEuler } from '../core/euler.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { type Quaternion, quaternionOf, type Triple } from '../formats/ball-values.ts';

/** The angles that are known for one ball joint. */
interface KnownAngles {
  /** The angles last shown. */
  latest: Readonly<Triple>;
  /** The angles at which each quaternion was shown, the oldest first. */
  readonly shown: Map<string, Readonly<Triple>>;
}

/**
 * The number of quaternions per ball whose angles are kept: enough for a long drag and the edits
 * before it.
 */
const mostKnown = 4096;

/**
 * The three angles at which ball joints are shown, R = Rx · Ry · Rz. They belong to the session,
 * because the scene stores quaternions, and the angles of a quaternion are ambiguous, most of all
 * where the second is a right angle and the first and third rotate about the same axis. The angles
 * of a slider are therefore stored with the quaternion that they gave, and return with that
 * quaternion (after undo or a canceled drag). For a quaternion from elsewhere the angles are
 * computed, nearest to those last shown.
 */
export class BallAngles {
  private readonly known = new WeakMap<Skeleton, Map<number, KnownAngles>>();

  /** @param index where the four values of the ball start in q */
  of(skeleton: Skeleton, q: Float64Array, index: number): Readonly<Triple> {
    const known = this.knownOf(skeleton, index);
    const key = keyOf(q, index);
    known.latest = known.shown.get(key) ?? anglesOf(q, index, known.latest);
    remember(known, key);
    return known.latest;
  }

  /** Returns the pose with one angle of a ball changed and its other two as they are shown. */
  withAngle(
    skeleton: Skeleton,
    q: Float64Array,
    index: number,
    axis: 0 | 1 | 2,
    angle: number,
  ): Float64Array {
    const angles: Triple = [...this.of(skeleton, q, index)];
    angles[axis] = angle;
    const changed = q.slice();
    changed.set(quaternionOf(angles), index);
    const known = this.knownOf(skeleton, index);
    known.latest = angles;
    remember(known, keyOf(changed, index));
    return changed;
  }

  private knownOf(skeleton: Skeleton, index: number): KnownAngles {
    let balls = this.known.get(skeleton);
    if (!balls) this.known.set(skeleton, (balls = new Map<number, KnownAngles>()));
    let known = balls.get(index);
    if (!known) {
      // A reset shows the file's pose with small angles, whatever was shown before.
      const latest = anglesOf(skeleton.qRest, index, [0, 0, 0]);
      known = { latest, shown: new Map([[keyOf(skeleton.qRest, index), latest]]) };
      balls.set(index, known);
    }
    return known;
  }
}

/**
 * Moves the key to the end. The oldest key makes room, but the first one, the file's pose, stays.
 */
function remember({ latest, shown }: KnownAngles, key: string): void {
  const [rest, oldest] = shown.keys();
  if (key !== rest) shown.delete(key);
  shown.set(key, latest);
  if (shown.size > mostKnown) shown.delete(oldest!);
}

function anglesOf(q: Float64Array, index: number, near: Readonly<Triple>): Readonly<Triple> {
  const quaternion = [...q.subarray(index, index + 4)] as Quaternion;
  return extractEuler(mat4.fromQuat(new Float64Array(16), quaternion), 'xyz', near);
}

function keyOf(q: Float64Array, index: number): string {
  return q.subarray(index, index + 4).join();
}
