import { cycle, type Curve, type Design } from './curves.ts';
import { onBothSides, stance } from './human-stance.ts';

/** One breath, in seconds. */
const length = 4;

/** The weight goes this far to the side and back, in meters, over legs of this length. */
const [sway, legLength] = [0.012, 0.84];
const lean = sway / legLength;

/** The human stands, breathes, and shifts its weight a little. */
export const humanIdle: Design = {
  length,
  isCycle: true,
  joints: {
    ...stance,
    // Breathing in takes less time than breathing out.
    'Lower back': [at(-0.02, -0.024, -0.028, -0.026, -0.022, -0.02), 0, side(-0.3)],
    Spine: [at(0, -0.012, -0.02, -0.016, -0.006, 0), 0, side(-0.4)],
    Chest: [at(0.03, 0.008, -0.008, -0.002, 0.016, 0.03), 0, side(-0.3)],
    Neck: [at(0.04, 0.05, 0.056, 0.052, 0.046, 0.04), 0, side(0.3)],
    Head: [
      at(-0.05, -0.046, -0.04, -0.044, -0.05, -0.052),
      at(0.04, 0.05, 0.02, -0.04, -0.05, -0.01),
      side(0.3),
    ],
    Hips: [0, 0, side(0.5)],
    ...onBothSides({
      shoulder: [0, 0, at(0.03, 0, -0.02, -0.012, 0.014, 0.03)],
      'upper arm': [
        at(0.03, 0.02, 0.01, 0.014, 0.024, 0.03),
        0.1,
        at(0.55, 0.555, 0.565, 0.565, 0.555, 0.55),
      ],
      forearm: [at(0.26, 0.25, 0.23, 0.23, 0.25, 0.26), -0.3, 0.2],
    }),
    // The hips lean over feet that stay.
    'Right upper leg': [-0.02, -0.1, side(-1.5, 0.03)],
    'Left upper leg': [-0.02, 0.1, side(-1.5, -0.03)],
    'Right foot': [-0.02, 0, side(1, -0.03)],
    'Left foot': [-0.02, 0, side(1, 0.03)],
  },
  root: { name: 'Root', place: [at(0, sway * 0.6, sway, sway * 0.9, sway * 0.4, 0), 0, 0] },
};

function at(...values: number[]): Curve {
  return cycle(length, values);
}

/** A part of the lean, about an angle. */
function side(part: number, about = 0): Curve {
  return at(...[0, 0.6, 1, 0.9, 0.4, 0].map((weight) => about + weight * part * lean));
}
