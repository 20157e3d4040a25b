import type { Design, Key } from './curves.ts';
import { stance } from './human-stance.ts';

/** The arm is up from here to there, and at rest again at the end; in seconds. */
const [up, down, length] = [0.6, 2.1, 2.8];

/** Half a stroke of the hand, in seconds. */
const stroke = 0.25;

/** The human raises its right hand, waves three times, and lowers it. */
export const humanWave: Design = {
  length,
  isCycle: false,
  joints: {
    ...stance,
    'Lower back': [-0.02, 0, raised(0, 0.02, 0.03)],
    Spine: [0, raised(0, 0.02, 0.04), raised(0, 0.02, 0.03)],
    Chest: [0.03, raised(0, 0.03, 0.06), raised(0, 0.01, 0.02)],
    Neck: [0.04, raised(0, -0.03, -0.04), 0],
    Head: [raised(-0.05, -0.09, -0.07), raised(0, -0.05, -0.08), raised(0, -0.05, -0.07)],
    'Right shoulder': [0, 0, raised(0.03, -0.18, -0.16)],
    'Right upper arm': [
      raised(0.03, -0.35, -0.3),
      raised(0.1, -0.2, -0.1),
      raised(0.55, -0.62, -0.5),
    ],
    'Right forearm': [
      raised(0.26, -1.5, -1.35),
      raised(-0.3, 0.1, 0),
      [[0, 0.2], [0.2, 0.12], ...strokes(0, -0.06, 0.28), [down + 0.3, 0.1], [length, 0.2]],
    ],
    'Right hand': [
      [
        [0, 0.03],
        [0.3, 0.3],
        [up, 0.02],
        [down, 0],
        [down + 0.3, 0.3],
        [length, 0.03],
      ],
      [
        [0, -0.05],
        [up, 0],
        [down, 0],
        [length, -0.05],
      ],
      // The wrist is soft: it follows the forearm late.
      [[0, 0.14], ...strokes(0.09, 0.02, 0.13), [down + 0.35, 0.1], [length, 0.14]],
    ],
    'Right palm': [raised(0.08, -0.04, -0.02), raised(0.1, 0, 0), 0.06],
    'Right fingers': [raised(0.13, 0, 0.02), raised(0.18, 0.02, 0.02), 0.1],
  },
};

/** From a value at rest up to another one, a little past it first, and back. */
function raised(rest: number, past: number, held: number): readonly Key[] {
  return [
    ...([[0, rest]] as const),
    ...([
      [up, past],
      [up + 0.25, held],
      [down, held],
    ] as const),
    [length, rest],
  ];
}

/** Three strokes to both sides about an angle, which begin so many seconds late. */
function strokes(late: number, about: number, reach: number): readonly Key[] {
  return Array.from({ length: 6 }, (_, at): Key => {
    const fades = at === 5 ? 0.6 : 1;
    return [up + late + at * stroke, about + (at % 2 === 0 ? -1 : 1) * reach * fades];
  });
}
