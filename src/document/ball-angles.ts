import { mat4 } from 'gl-matrix';
import { extractEuler } from '../core/euler.ts';
import type { Skeleton } from '../core/skeleton.ts';
import { quaternionOf, type Triple } from '../formats/ball-values.ts';
import { type AngleConvention, ShownAngles } from './shown-angles.ts';

/** R = Rx · Ry · Rz. */
const ballConvention: AngleConvention = {
  anglesOf(quaternion, near) {
    const rotation = new Float64Array(16);
    mat4.fromRotationTranslation(rotation, Array.from(quaternion), [0, 0, 0]);
    return extractEuler(rotation, 'xyz', near);
  },
  quaternionOf: (angles) => quaternionOf([...angles]),
};

/** The three angles at which ball joints are shown, R = Rx · Ry · Rz. */
export class BallAngles {
  private readonly known = new WeakMap<Skeleton, Map<number, ShownAngles>>();

  /** @param index where the four values of the ball start in q */
  of(skeleton: Skeleton, q: Float64Array, index: number): Readonly<Triple> {
    return this.knownOf(skeleton, index).of(q.subarray(index, index + 4));
  }

  /** Returns the pose with one angle of a ball changed and its other two as they are shown. */
  withAngle(
    skeleton: Skeleton,
    q: Float64Array,
    index: number,
    axis: 0 | 1 | 2,
    angle: number,
  ): Float64Array {
    const ball = q.subarray(index, index + 4);
    const changed = q.slice();
    changed.set(this.knownOf(skeleton, index).withAngle(ball, axis, angle), index);
    return changed;
  }

  private knownOf(skeleton: Skeleton, index: number): ShownAngles {
    let balls = this.known.get(skeleton);
    if (!balls) this.known.set(skeleton, (balls = new Map<number, ShownAngles>()));
    let known = balls.get(index);
    if (!known) {
      known = new ShownAngles(skeleton.qRest.subarray(index, index + 4), ballConvention);
      balls.set(index, known);
    }
    return known;
  }
}
