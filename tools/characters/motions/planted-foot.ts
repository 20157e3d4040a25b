import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { axisDofs } from '../../../src/core/pose.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { bindMotion } from '../../../src/formats/motion/bind-motion.ts';
import { readMotionText } from '../../../src/formats/motion/read-motion.ts';
import {
  type Curve,
  cycle,
  type Design,
  halfLater,
  mirrored,
  motionJson,
  type Turn,
} from './curves.ts';

/** The right leg is solved at so many equal parts of the cycle. */
const parts = 16;
/** The parts in which the ball of the right foot stands: from the flat foot until it leaves the floor. */
const [firstDown, lastDown] = [2, 8];
/** How much of the nearest correction the parts before and after get, so that the leg does not jerk. */
const ramp = [0.6, 0.2] as const;

const ball = 'Right toes';
type Vector3 = readonly [x: number, y: number, z: number];
/** What is added to the angles of the thigh about x and z, in radians. */
type Change = readonly [forward: number, aside: number];

/**
 * Returns a walk in place whose feet go straight back at one speed while they stand, as on a treadmill.
 * The thighs are solved for it at parts of the cycle; the knees stay and the feet keep their pitch. The
 * height of the body follows; see `withFeetDown`.
 */
export function withFeetPlanted(design: Design, character: Character): Design {
  const { skeleton } = character;
  const read = readMotionText('motion', JSON.stringify(motionJson(design)));
  const clip = clipFor(bindMotion(read.value!, character).value!, character);
  const indexOf = (name: string, axis: number): number =>
    axisDofs(skeleton, skeleton.names.indexOf(name)).find(
      (dof) => dof.kind === DofKind.hinge && dof.axis === axis,
    )!.index;
  const [thighX, thighZ] = [indexOf('Right upper leg', 0), indexOf('Right upper leg', 2)];
  const foot = indexOf('Right foot', 0);
  const at = skeleton.names.indexOf(ball) * 16;
  const poses = Array.from({ length: parts }, (_, part) => {
    const q = skeleton.qRest.slice();
    const none = new Float64Array(skeleton.jointCount * 4);
    evaluateClip(clip, (part * design.length) / parts, { q, morphWeights: none, pins: none });
    return q;
  });
  const placeOf = (q: Float64Array): Vector3 => {
    const [x, y, z] = jointMatrices(skeleton, q).subarray(at + 12, at + 15);
    return [x!, y!, z!];
  };
  const changed = (q: Float64Array, [forward, aside]: Change): Float64Array => {
    const own = q.slice();
    own[thighX]! += forward;
    own[thighZ]! += aside;
    own[foot]! -= forward;
    return own;
  };
  const places = poses.map(placeOf);
  const down = places.slice(firstDown, lastDown + 1);
  const side = down.reduce((sum, [x]) => sum + x, 0) / down.length;
  const [front, back] = [down[0]![2], down.at(-1)![2]];
  const changes = poses.map((q, part): Change => {
    const u = (part - firstDown) / (lastDown - firstDown);
    if (u < 0 || u > 1) return [0, 0];
    const wanted: Vector3 = [side, 0, front + (back - front) * u];
    return solveFor(wanted, (change) => placeOf(changed(q, change)));
  });
  ramp.forEach((share, away) => {
    changes[(firstDown - 1 - away + parts) % parts] = scaled(changes[firstDown]!, share);
    changes[lastDown + 1 + away] = scaled(changes[lastDown]!, share);
  });
  const legs = poses.map((q, part) => changed(q, changes[part]!));
  const curve = (index: number): Curve =>
    cycle(
      design.length,
      legs.map((q) => q[index]!),
    );
  const { joints, length } = design;
  const [, thighY] = joints['Right upper leg']!;
  const [, footY, footZ] = joints['Right foot']!;
  const turns: Readonly<Record<string, Turn>> = {
    'upper leg': [curve(thighX), thighY, curve(thighZ)],
    foot: [curve(foot), footY, footZ],
  };
  const both = Object.entries(turns).flatMap(([name, [x, y, z]]) => [
    [`Right ${name}`, [x, y, z]] as const,
    [
      `Left ${name}`,
      mirrored([halfLater(x, length), halfLater(y, length), halfLater(z, length)]),
    ] as const,
  ]);
  return { ...design, joints: { ...joints, ...Object.fromEntries(both) } };
}

function scaled([forward, aside]: Change, by: number): Change {
  return [forward * by, aside * by];
}

/** Newton's method with differences; the leg is never far from its solution. */
function solveFor([x, , z]: Vector3, placeOf: (change: Change) => Vector3): Change {
  const small = 1e-6;
  let change: Change = [0, 0];
  for (let round = 0; round < 12; round++) {
    const now = placeOf(change);
    const [forward, aside] = [
      placeOf([change[0] + small, change[1]]),
      placeOf([change[0], change[1] + small]),
    ].map((moved) => [(moved[0] - now[0]) / small, (moved[2] - now[2]) / small] as const);
    const [missingX, missingZ] = [x - now[0], z - now[2]];
    const [a, b] = [forward!, aside!];
    const whole = a[0] * b[1] - a[1] * b[0];
    change = [
      change[0] + (missingX * b[1] - missingZ * b[0]) / whole,
      change[1] + (a[0] * missingZ - a[1] * missingX) / whole,
    ];
  }
  return change;
}
