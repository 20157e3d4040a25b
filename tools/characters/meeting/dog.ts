import type { PoseJson } from '../../../src/formats/pose-json.ts';
import { subtract, type Vector3 } from '../vector.ts';
import type { Figure } from './figure.ts';
import { aboveFloor, along, at, near, onFloor } from './goals.ts';
import { solvePose } from './solve.ts';

const BACK = [1, 2, 3, 4, 5, 6, 7].map((index) => `Lower back ${index}`);
const NECK = [1, 2, 3, 4, 5, 6, 7].map((index) => `Neck ${index}`);
const TAIL = Array.from({ length: 21 }, (_, index) => `Tail ${index + 1}`);
const SIDES = ['Left', 'Right'] as const;

/** Sits, with the tail on the floor, and gives the left paw. */
const first: PoseJson = {
  joints: {
    Chest: [-0.65, 0, 0],
    ...Object.fromEntries(BACK.map((joint) => [joint, [-0.03, 0, 0]])),
    Hips: [-0.05, 0, 0],
    ...Object.fromEntries(
      SIDES.flatMap((side) => [
        [`${side} hind upper leg`, [-0.7, 0, side === 'Left' ? 0.15 : -0.15]],
        [`${side} hind lower leg`, [1.5, 0, 0]],
        [`${side} hind foot`, [-1.4, 0, 0]],
        [`${side} hind toes`, [1.35, 0, 0]],
      ]),
    ),
    ...Object.fromEntries(NECK.map((joint) => [joint, [0.06, 0, 0]])),
    Head: [0.1, 0, 0],
    'Lower jaw': [-0.2, 0, 0],
    ...Object.fromEntries(TAIL.map((joint, index) => [joint, [index < 6 ? 0.13 : 0.03, 0.03, 0]])),
    'Left shoulder': [0, 0, 0],
    'Left front upper leg': [-0.4, 0, 0],
    'Left front lower leg': [-0.1, 0, 0],
    'Left front foot': [0.3, 0, 0],
    'Left front toes': [0.2, 0, 0],
    'Right shoulder': [0.2, 0, 0],
    'Right front upper leg': [0.25, 0, 0],
    'Right front lower leg': [0.2, 0, 0],
    'Right front foot': [0, 0, 0],
    'Right front toes': [0, 0, 0],
  },
  root: [0, 0, -0.1],
};

function stiffnessOf(joint: string): number {
  if (/back|Neck|Tail|Chest|Hips/.test(joint)) return 2;
  if (/shoulder|front upper leg|toes/.test(joint)) return 1;
  return 0.3;
}

/** Of each side: how far from the middle. */
const sideOf = (side: string): number => (side === 'Left' ? 1 : -1);

/**
 * @param meeting where the pads of the paw are, in the dog's space
 * @param face where the person's face is
 */
export function solveDog(figure: Figure, meeting: Vector3, face: Vector3): Float64Array {
  const pads = figure.region(['Left front toes'], [0, -1, 0]);
  const rump = figure.region(['Hips', 'Left hind upper leg', 'Right hind upper leg']);
  const tail = figure.region(TAIL);
  const hind = SIDES.map((side) => figure.region([`${side} hind foot`, `${side} hind toes`]));
  const hocks = SIDES.map((side) => figure.region([`${side} hind lower leg`]));
  const frontPaw = figure.region(['Right front toes', 'Right front foot']);
  return solvePose(
    figure,
    first,
    (posed) => [
      onFloor(posed.bottom(rump)),
      onFloor(posed.bottom(frontPaw)),
      aboveFloor(posed.bottom(tail) - 0.002),
      ...near(posed.place('Right front toes'), { x: -0.05, z: 0.26 }),
      ...along(posed.direction('Right front lower leg', [0, -1, 0]), [0, -1, 0.05], 2),
      ...along(posed.direction('Right front toes', [0, 1, 0]), [0, 1, 0], 2),
      ...SIDES.flatMap((side, index) => [
        onFloor(posed.bottom(hind[index]!)),
        aboveFloor(posed.bottom(hocks[index]!)),
        ...near(posed.place(`${side} hind toes`), { x: sideOf(side) * 0.1, y: 0.03 }),
        ...near(posed.place(`${side} hind foot`), { x: sideOf(side) * 0.08, y: 0.035 }),
        ...along(posed.direction(`${side} hind toes`, [0, 1, 0]), [0, 1, 0], 2),
        ...along(posed.direction(`${side} hind toes`, [0, 0, 1]), [sideOf(side) * 0.2, 0, 1], 2),
        ...along(posed.direction(`${side} hind foot`, [0, -1, 0]), [sideOf(side) * 0.2, 0, 1], 1),
        ...near(posed.place(`${side} hind lower leg`), { x: sideOf(side) * 0.12, y: 0.18 }, 2),
      ]),
      ...at(posed.middle(pads), meeting, 4),
      ...along(posed.direction('Left front lower leg', [0, -1, 0]), [0, -0.3, 1], 1),
      ...along(posed.direction('Left front foot', [0, -1, 0]), [0, -0.6, 1], 2),
      ...along(posed.direction('Left front toes', [0, 1, 0]), [0, 1, 0.6], 1.5),
      ...along(posed.direction('Head', [0, 0, 1]), subtract(face, posed.place('Head')), 2),
    ],
    stiffnessOf,
  );
}
