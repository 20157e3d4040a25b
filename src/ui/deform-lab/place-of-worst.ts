import { vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { clipFromScene, eyeOf } from '../../view/camera.ts';
import type { Compared } from './compared.ts';

/** Where the base and another method put the point at which they differ most, in the scene. */
export interface WorstPlace {
  readonly point: number;
  readonly base: vec3;
  readonly other: vec3;
}

export function placeOfWorst({ base, worst }: Compared): WorstPlace | null {
  if (!worst) return null;
  const point = worst.difference.worst;
  return {
    point,
    base: scenePoint(base.evaluation, point),
    other: scenePoint(worst.evaluation, point),
  };
}

/** A place of the view: parts of its width and height from the upper left corner. */
export function viewPlace(camera: Camera, aspect: number, point: vec3): readonly [number, number] {
  const clip = vec3.transformMat4(new Float64Array(3), point, clipFromScene(camera, aspect));
  return [(1 + clip[0]) / 2, (1 - clip[1]) / 2];
}

/**
 * Whether the figure of a mark stands at its left.
 *
 * @param x of the mark, as a part of the view's width
 */
export function textIsLeft(x: number): boolean {
  return x > 0.6;
}

/**
 * How near the camera goes, as a part of the diagonal of the character's bounding box: so that one
 * sees which limb it is, of one that stands and of one that lies.
 */
const nearness = 0.8;
/** Up to this cosine, a surface that points away from the viewer still counts as seen. */
const seen = -0.15;

/**
 * The camera as it looks at the place, from outside of the character, and near enough to see it.
 *
 * @param aspect of a view; in narrow ones the camera is farther away, so that as much is beside the place
 */
export function cameraAt(
  camera: Camera,
  aspect: number,
  { base: shown, size }: Compared,
  place: WorstPlace,
): Camera {
  const middle = vec3.lerp(new Float64Array(3), place.base, place.other, 0.5);
  const outward = sceneNormal(shown.evaluation, place.point);
  const toViewer = vec3.subtract(new Float64Array(3), eyeOf(camera), camera.target);
  vec3.normalize(toViewer, toViewer);
  const isBehind = vec3.dot(outward, toViewer) < seen;
  const near = (nearness * size.diagonal * shown.evaluation.display.scale) / Math.min(1, aspect);
  return {
    ...camera,
    target: [middle[0], middle[1], middle[2]],
    distance: Math.min(camera.distance, near),
    ...(isBehind && { azimuth: Math.atan2(outward[0], outward[2]) }),
  };
}

function scenePoint(evaluation: Evaluation, point: number): vec3 {
  const at = evaluation.vertices().positions.slice(point * 3, point * 3 + 3);
  return vec3.transformMat4(new Float64Array(3), at, evaluation.display.sceneFromCharacter);
}

/** The unit normal of a point. */
function sceneNormal(evaluation: Evaluation, point: number): vec3 {
  const { positions, normals } = evaluation.vertices();
  const tip: vec3 = [0, 1, 2].map((i) => positions[point * 3 + i]! + normals[point * 3 + i]!);
  const turned = vec3.transformMat4(
    new Float64Array(3),
    tip,
    evaluation.display.sceneFromCharacter,
  );
  vec3.subtract(turned, turned, scenePoint(evaluation, point));
  return vec3.normalize(turned, turned);
}
