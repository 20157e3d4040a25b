import type { Quaternion, Triple } from '../formats/ball-values.ts';

/** How the angles of one convention and quaternions become one another. */
export interface AngleConvention {
  /** @param near of the triples that give the rotation, the nearest to this one is returned */
  anglesOf(quaternion: ArrayLike<number>, near: Readonly<Triple>): Readonly<Triple>;
  quaternionOf(angles: Readonly<Triple>): Readonly<Quaternion>;
}

/** The number of quaternions whose angles are kept: enough for a long drag and the edits before it. */
const mostKnown = 4096;

/**
 * The three angles at which a rotation is shown. They belong to the session, because the scene
 * stores quaternions, and the angles of a quaternion are ambiguous, most of all where the middle one
 * is a right angle and the two others rotate about the same axis. The angles of a slider are
 * therefore stored with the quaternion that they gave, and return with that quaternion (after undo
 * or a canceled drag). For a quaternion from elsewhere the angles are computed, nearest to those
 * last shown.
 */
export class ShownAngles {
  private readonly convention: AngleConvention;
  /** The angles last shown. */
  private latest: Readonly<Triple>;
  /** The angles at which each quaternion was shown, the oldest first. */
  private readonly shown = new Map<string, Readonly<Triple>>();

  /** @param rest a reset shows it with small angles, whatever was shown before */
  constructor(rest: ArrayLike<number>, convention: AngleConvention) {
    this.convention = convention;
    this.latest = convention.anglesOf(rest, [0, 0, 0]);
    this.shown.set(keyOf(rest), this.latest);
  }

  of(quaternion: ArrayLike<number>): Readonly<Triple> {
    const key = keyOf(quaternion);
    this.latest = this.shown.get(key) ?? this.convention.anglesOf(quaternion, this.latest);
    this.remember(key);
    return this.latest;
  }

  /** Returns the quaternion with one angle changed and the other two as they are shown. */
  withAngle(quaternion: ArrayLike<number>, axis: 0 | 1 | 2, angle: number): Readonly<Quaternion> {
    const angles: Triple = [...this.of(quaternion)];
    angles[axis] = angle;
    const changed = this.convention.quaternionOf(angles);
    this.latest = angles;
    this.remember(keyOf(changed));
    return changed;
  }

  /** Moves the key to the end. The oldest key makes room, but the first one, the rest, stays. */
  private remember(key: string): void {
    const { shown } = this;
    const [rest, oldest] = shown.keys();
    if (key !== rest) shown.delete(key);
    shown.set(key, this.latest);
    if (shown.size > mostKnown) shown.delete(oldest!);
  }
}

function keyOf(quaternion: ArrayLike<number>): string {
  return Array.from(quaternion).join();
}
