import { vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { viewPlace } from '../deform-lab/place-of-worst.ts';
import type { InspectedMethod } from './inspected.ts';
import { entryName } from './vertex-weights.ts';

/** A name beside a place of the view. */
export interface GhostLabel {
  readonly text: string;
  /** Parts of the view's width and height, from its upper left corner. */
  readonly x: number;
  readonly y: number;
  /** Whether it is left of the vertex, so that a name at its left does not hide that. */
  readonly isLeft: boolean;
}

/** So many ghosts are named, those of the largest weights; more would hide the skin. */
const mostGhosts = 6;
const leastWeight = 0.005;

/**
 * The names of what is drawn around an inspected vertex: joints with their weights at their ghosts, and
 * further places of each method. What is out of the view is left out.
 *
 * @param aspect of the view
 */
export function ghostLabels(
  methods: readonly InspectedMethod[],
  camera: Camera,
  aspect: number,
): readonly GhostLabel[] {
  const [first] = methods;
  if (!first?.evaluation.state.look.visible) return [];
  const { sceneFromCharacter } = first.evaluation.display;
  const inView = (place: Vector3): readonly [number, number] => {
    const inScene = vec3.transformMat4(new Float64Array(3), place, sceneFromCharacter);
    return viewPlace(camera, aspect, inScene);
  };
  const [vertexX] = inView(first.place);
  const label = (text: string, place: Vector3): GhostLabel => {
    const [x, y] = inView(place);
    return { text, x, y, isLeft: x <= vertexX };
  };
  const ghosts = first.ghosts
    .filter(({ weight }) => Math.abs(weight) >= leastWeight)
    .sort((a, b) => Math.abs(b.weight) - Math.abs(a.weight))
    .slice(0, mostGhosts)
    .map(({ entry, weight, place }) => {
      const name = entryName(first.evaluation.state, entry);
      return label(`${name} ${Number(weight.toFixed(2))}`, place);
    });
  const marks = methods.flatMap((method) =>
    method.marks.map(({ label: name, place }) => label(name, place)),
  );
  return [...ghosts, ...marks].filter(({ x, y }) => x > 0 && x < 1 && y > 0 && y < 1);
}

/** The side of the inspected vertex at which a figure stands already, if any does. */
export type FigureSide = 'left' | 'right' | null;

/** A name has so much room beside its place, in CSS pixels, or stands at the other side. */
const leastRoom = 120;

/**
 * Whether a name stands at the left of its place: away from a figure, else away from the vertex,
 * where there is room.
 *
 * @param width of the view, in CSS pixels
 */
export function standsLeft(
  { x, isLeft }: Pick<GhostLabel, 'x' | 'isLeft'>,
  width: number,
  figure: FigureSide,
): boolean {
  const wanted = figure === null ? isLeft : figure === 'right';
  const room = (wanted ? x : 1 - x) * width;
  return room > leastRoom ? wanted : x > 0.5;
}

/** Moves heights down where they would be nearer to each other than the gap; order stays. */
export function spreadHeights(heights: readonly number[], gap: number): readonly number[] {
  const order = [...heights.keys()].sort((a, b) => heights[a]! - heights[b]!);
  const spread = [...heights];
  let next = -Infinity;
  for (const index of order) {
    spread[index] = Math.max(heights[index]!, next);
    next = spread[index] + gap;
  }
  return spread;
}
