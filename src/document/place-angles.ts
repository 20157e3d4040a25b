import { mat3, quat } from 'gl-matrix';
import { extractEuler } from '../core/euler.ts';
import type { Quaternion, Triple } from '../formats/ball-values.ts';
import { type ActorId, type Transform, unmoved } from './scene.ts';
import { type AngleConvention, ShownAngles } from './shown-angles.ts';

/**
 * R = Ry · Rx · Rz: a character turns about the vertical, then leans forward, then to its side, so
 * that whole turns about the vertical leave the two other angles alone.
 */
const placeConvention: AngleConvention = {
  anglesOf(quaternion, near) {
    const rotation = mat3.fromQuat(new Float64Array(9), Array.from(quaternion));
    // With its axes renamed in a circle, y to z, x to y and z to x, the product is Rz · Ry · Rx.
    const renamed = new Float64Array(11);
    const old = [2, 0, 1] as const;
    for (let column = 0; column < 3; column++) {
      for (let row = 0; row < 3; row++) {
        renamed[column * 4 + row] = rotation[old[column]! * 3 + old[row]!]!;
      }
    }
    const [z, x, y] = extractEuler(renamed, 'zyx', [near[2], near[0], near[1]]);
    return [x, y, z];
  },
  quaternionOf([x, y, z]) {
    const turn = aboutAxis(1, y);
    quat.multiply(turn, turn, aboutAxis(0, x));
    return [...quat.multiply(turn, turn, aboutAxis(2, z))] as Quaternion;
  },
};

/** The three angles at which the rotations of actors are shown, R = Ry · Rx · Rz. */
export class PlaceAngles {
  private readonly known = new Map<ActorId, ShownAngles>();

  of(id: ActorId, rotation: Transform['rotation']): Readonly<Triple> {
    return this.knownOf(id).of(rotation);
  }

  /** Returns the transform with one angle changed and the other two as they are shown. */
  withAngle(id: ActorId, transform: Transform, axis: 0 | 1 | 2, angle: number): Transform {
    return { ...transform, rotation: this.knownOf(id).withAngle(transform.rotation, axis, angle) };
  }

  private knownOf(id: ActorId): ShownAngles {
    let known = this.known.get(id);
    if (!known) {
      known = new ShownAngles(unmoved.rotation, placeConvention);
      this.known.set(id, known);
    }
    return known;
  }
}

function aboutAxis(axis: 0 | 1 | 2, angle: number): quat {
  const about = new Float64Array(4);
  about[axis] = Math.sin(angle / 2);
  about[3] = Math.cos(angle / 2);
  return about;
}
