import { vec3 } from 'gl-matrix';
import { noJoint } from '../core/skin.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Explanation } from '../evaluation/explain/explanation.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { jointColorsOf } from '../skinning/weights/joint-colors.ts';
import { circleAt } from './chain-shapes.ts';
import type { Overlay, OverlayFace, OverlayLine, OverlayView } from './overlay.ts';
import { linear } from './theme.ts';

/** How one method reaches a vertex of a character. */
export type InspectedPlace = Pick<Explanation, 'ghosts' | 'marks' | 'place'> & {
  readonly evaluation: Pick<Evaluation, 'display' | 'skin' | 'state'>;
};

/** Nothing of it is picked. */
const id = 'inspection';
/** In CSS pixels: a ghost without weight and what all of the weight adds to it, in radius and line. */
const [ghostRadius, weightRadius, lineWidth, weightWidth] = [2.5, 5.5, 1, 3.5];
const [placeRadius, markRadius, rimWidth] = [5, 5.5, 1.5];
const [apartWidth, markWidth] = [2.5, 1.5];
const [lineOpacity, markOpacity] = [0.9, 0.85];
const rimColor = linear('#1c2430');
/** The places to which methods bring the vertex, in the order of the methods. */
const placeColors = ['#ffffff', '#e0218a', '#2f7fd6', '#12a374'].map(linear);
const noColor = linear('#8e9aa8');

/**
 * Returns the shapes of a vertex: a ghost where each joint alone would take it, larger for more
 * weight, in the color of the joint, with a line to the vertex; rings at further places of each
 * method, with lines to where it puts the vertex; and lines from there to where the first method
 * puts it.
 */
export function inspectionShapes(places: readonly InspectedPlace[], view: OverlayView): Overlay {
  const [first] = places;
  if (!first?.evaluation.state.look.visible) return [];
  const { sceneFromCharacter } = first.evaluation.display;
  const toScene = (place: Vector3): vec3 =>
    vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
  const line = (from: vec3, to: vec3, color: readonly number[], width: number, opacity: number) => {
    return { id, points: [from, to], color, width, opacity } satisfies OverlayLine;
  };
  const dot = (at: vec3, radius: number, color: readonly number[]): OverlayFace[] =>
    [
      { radius: radius + rimWidth, paint: rimColor },
      { radius, paint: color },
    ].map(({ radius: size, paint }) => {
      return { id, points: circleAt(at, view, size), color: paint, opacity: 1, isFilled: true };
    });
  const goal = toScene(first.place);
  const ghosts = first.ghosts
    .filter(({ weight }) => weight !== 0)
    .map(({ entry, weight, place }) => {
      const part = Math.min(1, Math.abs(weight));
      return { at: toScene(place), part, color: colorOf(first.evaluation, entry) };
    });
  const ends = places.map(({ place }) => toScene(place));
  const marks = places.flatMap((method, index) =>
    method.marks.flatMap(({ place }) => {
      const at = toScene(place);
      const color = placeColors[index % placeColors.length]!;
      const ring = circleAt(at, view, markRadius);
      return [
        line(at, ends[index]!, color, markWidth, markOpacity),
        { id, points: ring, color: rimColor, width: markWidth + 2, opacity: markOpacity },
        { id, points: ring, color, width: markWidth, opacity: 1 },
      ];
    }),
  );
  return [
    ...ghosts.map(({ at, part, color }) =>
      line(at, goal, color, lineWidth + weightWidth * part, lineOpacity),
    ),
    ...ends.slice(1).map((end, i) => {
      return line(goal, end, placeColors[(i + 1) % placeColors.length]!, apartWidth, 1);
    }),
    ...marks,
    ...ghosts.flatMap(({ at, part, color }) =>
      dot(at, ghostRadius + weightRadius * Math.sqrt(part), color),
    ),
    // The first method's place is over the others.
    ...[...ends.entries()]
      .reverse()
      .flatMap(([i, end]) => dot(end, placeRadius, placeColors[i % placeColors.length]!)),
  ];
}

function colorOf({ skin, state }: InspectedPlace['evaluation'], entry: number): readonly number[] {
  const joint = skin.paletteJoint[entry]!;
  if (joint === noJoint) return noColor;
  const { bytes } = jointColorsOf(state.character.skeleton);
  const own = Array.from(bytes.subarray(joint * 3, joint * 3 + 3));
  return linear(`#${own.map((byte) => byte.toString(16).padStart(2, '0')).join('')}`);
}
