import type { PoseJson } from '../../../src/formats/pose-json.ts';
import { add, cross, subtract, type Vector3 } from '../vector.ts';
import { type Figure, Posed } from './figure.ts';
import { aboveFloor, along, at, near, onFloor } from './goals.ts';
import { solvePose } from './solve.ts';

/** Kneels on the right knee, leans forward, and reaches out with the right hand, palm up. */
const first: PoseJson = {
  joints: {
    Hips: [0.12, 0, 0],
    'Lower back': [0.14, 0, 0],
    Spine: [0.12, 0, 0],
    Chest: [0.1, 0, 0],
    Neck: [0.04, 0, 0],
    'Upper neck': [0.06, 0, 0],
    Head: [0.1, 0, 0],
    'Right shoulder': [0, -0.1, 0],
    'Right upper arm': [-0.5, -0.3, 0.3],
    'Right forearm': [-0.3, -0.2, 0.3],
    'Right hand': [0, 0, -0.9],
    'Right palm': [-0.05, 0, 0],
    'Right fingers': [0.12, 0, 0],
    'Left shoulder': [0, 0.05, 0],
    'Left upper arm': [-0.3, 0.1, -0.25],
    'Left forearm': [-0.2, 0.1, -0.2],
    'Left hand': [0.1, 0, 0.3],
    'Left fingers': [0.1, 0, 0],
    'Right upper leg': [-0.15, 0, 0],
    'Right lower leg': [1.7, 0, 0],
    'Right foot': [0.1, 0, 0],
    'Right toes': [-1.1, 0, 0],
    'Left upper leg': [-1.45, 0.1, 0.12],
    'Left lower leg': [1.4, 0, 0],
    'Left foot': [0, 0, 0],
  },
  root: [0, -0.4, 0],
};

/** Legs and spine bend in one plane, nearly; arms turn freely. */
function stiffnessOf(joint: string): number {
  if (/Hips|back|Spine|Chest|shoulder/.test(joint)) return 1;
  if (/Neck|neck|Head|palm|fingers|foot|toes/.test(joint)) return 0.5;
  return 0.2;
}

/**
 * @param meeting where the palm holds the paw, in the person's space
 * @param face where the dog's face is
 */
export function solvePerson(figure: Figure, meeting: Vector3, face: Vector3): Float64Array {
  const atRest = new Posed(figure, figure.character.skeleton.qRest);
  const [right, left] = [palmOf(figure, atRest, 'Right'), palmOf(figure, atRest, 'Left')];
  const shin = figure.region(['Right lower leg']);
  const rightToes = figure.region(['Right toes']);
  const leftFoot = figure.region(['Left foot', 'Left toes']);
  return solvePose(
    figure,
    first,
    (posed) => {
      const knee = posed.place('Left lower leg');
      return [
        ...near(posed.place('Hips'), { x: 0, z: 0 }),
        ...near(posed.place('Right lower leg'), { x: -0.13, z: 0.05 }),
        onFloor(posed.bottom(shin)),
        onFloor(posed.bottom(rightToes)),
        ...along(posed.direction('Right toes', [0, 0, 1]), [0, 0, 1], 0.6),
        ...near(posed.place('Left foot'), { x: 0.17, z: 0.36 }),
        ...along(posed.direction('Left foot', [0, 1, 0]), [0, 1, 0], 3),
        ...along(posed.direction('Left foot', [0, 0, 1]), [0.15, 0, 1], 1),
        onFloor(posed.bottom(leftFoot)),
        ...at(posed.middle(right.skin), meeting, 4),
        ...along(posed.direction('Right palm', right.normal), [-0.1, 1, -0.15], 1.5),
        ...along(posed.direction('Right palm', right.fingers), [0.1, -0.15, 1], 1.5),
        ...at(posed.middle(left.skin), add(knee, [-0.01, 0.075, -0.07]), 2),
        ...along(posed.direction('Left palm', left.normal), [0, -1, -0.2], 1),
        ...along(posed.direction('Left palm', left.fingers), [-0.3, -0.2, 1], 0.7),
        ...along(posed.direction('Head', [0, 0.05, 1]), subtract(face, posed.place('Head')), 1.5),
        aboveFloor(posed.bottom(leftFoot)),
      ];
    },
    stiffnessOf,
  );
}

/** The palm's skin, and at rest its normal and the direction of the fingers. */
function palmOf(figure: Figure, atRest: Posed, side: 'Left' | 'Right') {
  const middleOf = (part: string): Vector3 => atRest.middle(figure.region([`${side} ${part}`]));
  const hand = middleOf('hand');
  const fingers = subtract(middleOf('fingers'), hand);
  const thumb = subtract(middleOf('thumb'), hand);
  const normal = side === 'Right' ? cross(thumb, fingers) : cross(fingers, thumb);
  return { fingers, normal, skin: figure.region([`${side} palm`, `${side} fingers`], normal) };
}
