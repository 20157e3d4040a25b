import type { Vector3 } from '../vector.ts';
import { atlas, fromFront, placeIn } from './atlas.ts';
import { bothSides, type InsectJoint, locked } from './joints.ts';
import { chainWeights, profile } from './profile.ts';
import { joined, type Station, type Surface, sweep } from './sweep.ts';

const hinge: Vector3 = [0.115, 0.635, 0.2];
const span = 1.06;
/** The place on the span where the outer wing bends. */
const fold = 0.46;

/** The z of the leading edge and of the trailing edge along the span, relative to the hinge. */
const outline = profile([
  // along, leading, trailing
  [0, 0.025, -0.03],
  [0.06, 0.04, -0.06],
  [0.2, 0.062, -0.17],
  [0.4, 0.085, -0.29],
  [0.6, 0.1, -0.33],
  [0.78, 0.09, -0.3],
  [0.9, 0.05, -0.22],
  [0.97, -0.01, -0.14],
  [1, -0.07, -0.08],
]);

/** Half the thickness of the membrane, and of the vein along its leading edge, in model units. */
const membrane = 0.0045;
const veinRadius = 0.0085;

/** The places along the span, which are denser where the tip is round. */
const along = Array.from({ length: 23 }, (_, index) => Math.sin((index / 22) * (Math.PI / 2)));

/** The height of the wing's center line: it rises from the thorax and droops toward the tip. */
function rise(t: number): number {
  return 0.12 * t - 0.09 * t * t;
}

function weightsAt(t: number): Station['weights'] {
  return chainWeights(
    [
      ['wing_l', -Infinity, 0],
      ['wing_l_fold', fold, 0.1],
    ],
    t,
  );
}

/** The left wing, bound straight out to the side: a thin closed blade and the vein of its edge. */
export function wingSurface(): Surface {
  const side: Vector3 = [0, 0, -1];
  const up: Vector3 = [0, 1, 0];
  const stations = along.map((t): Station => {
    const [leading, trailing] = outline(t);
    return {
      center: [hinge[0] + t * span, hinge[1] + rise(t), hinge[2] + (leading! + trailing!) / 2],
      side,
      up,
      width: (leading! - trailing!) / 2,
      height: membrane,
      along: t,
      weights: weightsAt(t),
    };
  });
  const edge = along.map((t, index): Station => {
    const [leading] = outline(t);
    const radius = index === 0 || index === along.length - 1 ? 0.001 : veinRadius * (1.6 - 1.1 * t);
    return {
      center: [hinge[0] + t * span, hinge[1] + rise(t), hinge[2] + leading! - 0.004],
      side,
      up,
      width: radius,
      height: radius * 0.8,
      along: t,
      weights: weightsAt(t),
    };
  });
  const toVein = (): number => 0.012;
  return joined([
    sweep(stations, 20, placeIn(atlas.wing, [0, 1], fromFront)),
    sweep(edge, 6, placeIn(atlas.wing, [0, 1], toVein)),
  ]);
}

/** The wing rotates about all axes; its outer part bends up and down and twists a little. */
export function wingJoints(): InsectJoint[] {
  const foldPosition: Vector3 = [hinge[0] + fold * span, hinge[1] + rise(fold), hinge[2] - 0.1];
  const root = bothSides({
    name: 'wing_l',
    parent: 'body',
    position: hinge,
    bind: [0, 0, 0],
    limits: [
      [-0.6, 0.6],
      [-0.2, 1.4],
      [-0.7, 1.3],
    ],
  });
  const outer = bothSides({
    name: 'wing_l_fold',
    parent: 'wing_l',
    position: foldPosition,
    bind: [0, 0, 0],
    limits: [[-0.2, 0.2], locked, [-0.5, 0.5]],
  });
  return [0, 1].flatMap((side) => [root[side]!, outer[side]!]);
}
