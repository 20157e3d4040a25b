import { type Curve, cycle, type Design, halfLater, mirrored, type Turn } from './curves.ts';
import { onBothSides, stance } from './human-stance.ts';

/** Two steps, in seconds. */
const length = 32 / 30;

/**
 * The right side from the contact of its heel, at eight equal parts of the two steps: contact, down,
 * passing, up, contact of the other heel, then its leg swings. Angles about x: thighs and arms go
 * forward by negative ones, knees bend by positive ones, and toes rise by negative ones.
 */
const rightLeg: Readonly<Record<string, Turn>> = {
  'upper leg': [
    at(-0.44, -0.36, -0.13, 0.12, 0.3, 0.2, -0.2, -0.47),
    -0.06,
    at(0.05, 0.118, 0.161, 0.12, 0.05, 0, 0.02, 0.05),
  ],
  'lower leg': [at(0.06, 0.24, 0.17, 0.1, 0.26, 0.62, 0.92, 0.4), 0, 0],
  foot: [at(0.02, 0.12, -0.04, -0.2, -0.1, 0.2, 0.02, -0.1), 0, -0.03],
  toes: [at(0, 0, 0, 0, -0.42, -0.25, 0, 0), 0, 0],
};

/** Each arm goes with the other leg; the forearm follows the upper arm late. */
const rightArm: Readonly<Record<string, Turn>> = {
  shoulder: [0, at(-0.05, -0.04, 0, 0.04, 0.05, 0.04, 0, -0.04), 0.03],
  'upper arm': [at(0.42, 0.34, 0.1, -0.18, -0.34, -0.28, -0.02, 0.28), 0.1, 0.52],
  forearm: [at(0.34, 0.36, 0.3, 0.16, 0.02, -0.04, 0.08, 0.24), -0.3, 0.2],
  hand: [at(0.06, 0.1, 0.1, 0.04, -0.02, -0.06, -0.04, 0.02), -0.05, 0.12],
};

/** The human walks in place. */
export const humanWalk: Design = {
  length,
  isCycle: true,
  joints: {
    ...stance,
    Hips: [
      0.03,
      at(0.1, 0.08, 0, -0.08, -0.1, -0.08, 0, 0.08),
      at(0, -0.04, -0.05, -0.02, 0, 0.04, 0.05, 0.02),
    ],
    'Lower back': [
      0,
      at(-0.05, -0.04, 0, 0.04, 0.05, 0.04, 0, -0.04),
      at(0, 0.02, 0.03, 0.01, 0, -0.02, -0.03, -0.01),
    ],
    Spine: [
      at(0.02, 0.04, 0.02, 0, 0.02, 0.04, 0.02, 0),
      at(-0.07, -0.06, 0, 0.06, 0.07, 0.06, 0, -0.06),
      0,
    ],
    Chest: [
      0.03,
      at(-0.08, -0.07, 0, 0.07, 0.08, 0.07, 0, -0.07),
      at(0, 0.01, 0.02, 0.01, 0, -0.01, -0.02, -0.01),
    ],
    Neck: [0.03, at(0.05, 0.04, 0, -0.04, -0.05, -0.04, 0, 0.04), 0],
    Head: [
      at(-0.05, -0.03, -0.05, -0.06, -0.05, -0.03, -0.05, -0.06),
      at(0.05, 0.04, 0, -0.04, -0.05, -0.04, 0, 0.04),
      0,
    ],
    ...onBothSides({ ...rightLeg, ...rightArm }, { ...other(rightLeg), ...other(rightArm) }),
  },
  // The height follows from the feet; see `withFeetDown`.
  root: { name: 'Root', place: [at(0, -0.012, -0.018, -0.01, 0, 0.012, 0.018, 0.01), 0, 0] },
};

function at(...values: number[]): Curve {
  return cycle(length, values);
}

/** The left side, which does the same half a cycle later. */
function other(side: Readonly<Record<string, Turn>>): Record<string, Turn> {
  const later = ([x, y, z]: Turn): Turn => [
    halfLater(x, length),
    halfLater(y, length),
    halfLater(z, length),
  ];
  return Object.fromEntries(
    Object.entries(side).map(([name, turn]) => [name, mirrored(later(turn))]),
  );
}
