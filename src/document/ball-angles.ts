import { mat4 } from 'gl-matrix';
import { extractEuler } from '../core/euler.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { type Quaternion, quaternionOf, type Triple } from '../formats/ball-values.ts';

/** Of one ball. */
interface KnownAngles {
  /** The angles last shown. */
  latest: Readonly<Triple>;
  /** Those that quaternions were shown by, the oldest first. */
  readonly shown: Map<string, Readonly<Triple>>;
}

/** Quaternions of a ball whose angles are known: those of a long drag, and of the edits before it. */
const mostKnown = 4096;

/**
 * The three angles by which balls are shown, R = Rx · Ry · Rz. They belong to the session: the scene
 * has quaternions, of which angles can't be told without choice, least of all where the second is a
 * right angle and first and third turn about one axis. So a slider's angles are kept beside the
 * quaternion that they wrote, and are there again when it is (an undo, a canceled drag). Of one that
 * came from elsewhere the angles are found anew, nearest to those last shown.
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

  /** The pose with one angle of a ball at a value and the others as they are shown. */
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
      // The file's pose is shown by small angles, whatever was shown before a reset.
      const latest = anglesOf(skeleton.qRest, index, [0, 0, 0]);
      known = { latest, shown: new Map([[keyOf(skeleton.qRest, index), latest]]) };
      balls.set(index, known);
    }
    return known;
  }
}

/** The key takes the last place; the first but the file's pose, which stays, makes room. */
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
