import { mat3, mat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import { sizeOf } from '../../evaluation/comparison/difference.ts';
import { jointReach } from '../../evaluation/comparison/joint-reach.ts';
import type { StressPose } from '../../evaluation/comparison/stress-poses.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { limbEnd } from '../../posing/telling-poses.ts';
import { halfHeightOf } from '../camera.ts';
import { turnOfPage } from '../turn-of-page.ts';
import { poseView } from './pose-picture.ts';
import { seenPart } from './seen-part.ts';

/** The least and the most that is shown around a joint, in heights of the character. */
const [nearest, farthest] = [0.06, 0.4];
/** The room around what bends with a joint, as a factor. */
const margin = 1.4;
/** How much a profile is seen from the preferred side, and how far an eye rises, in radians. */
const [tilt, highest] = [0.5, 1.1];
/** So near to the middle of the scene, a joint is on no side. */
const middle = 0.01;
/** The wanted direction is left for one that is better by this factor. */
const clearly = 1.3;
/** An axis that has this cosine with the bone twists it. */
const along = 0.8;

/**
 * The camera that shows what a joint does to the skin around it, near enough to see it: a bend in
 * profile, a twist from the side of the bone, both from in front and from outside of the body, unless
 * what matters is covered there or turned away, and seen better from another direction. The page goes
 * on while directions are tried.
 *
 * @param evaluation of the pose
 * @param weights (pointCount) how much each point matters; not negative
 */
export async function jointCamera(
  evaluation: Evaluation,
  { joint, axis }: StressPose,
  weights: Float32Array,
): Promise<Camera> {
  const { state, skin, characterFromJoint, display } = evaluation;
  const { height } = sizeOf(state.character);
  const fromJoint = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
  const sceneFromJoint = mat4.multiply(new Float64Array(16), display.sceneFromCharacter, fromJoint);
  const inScene = turning(sceneFromJoint);
  const place = mat4.getTranslation(new Float64Array(3), sceneFromJoint);
  const [turn, bone] = [inScene(axis), inScene(limbEnd(state.character, joint))];
  const isTwist = Math.abs(vec3.dot(turn, bone)) > along;
  const wanted = isTwist ? beside(turn, place) : profile(turn, place);
  const reach = margin * jointReach(state.character, skin, joint);
  const shown = Math.min(farthest * height, Math.max(nearest * height, reach));
  const distance = shown / halfHeightOf({ ...poseView, distance: 1 });
  const toCharacter = turning(mat4.invert(new Float64Array(16), display.sceneFromCharacter)!);
  const surface = { ...evaluation.vertices(), indices: state.character.mesh.indices };
  const middle = mat4.getTranslation(new Float64Array(3), fromJoint);
  const worth = (direction: vec3): number => {
    const square = { middle, direction: toCharacter(direction), half: shown, distance };
    const across = vec3.dot(direction, turn) ** 2;
    const telling = isTwist ? Math.sqrt(1 - across) : Math.sqrt(across);
    return seenPart(surface, weights, square) * (1 + telling);
  };
  let [toViewer, most] = [wanted, clearly * worth(wanted)];
  for (const direction of around) {
    await turnOfPage();
    const value = worth(direction);
    if (value > most) [toViewer, most] = [direction, value];
  }
  return {
    ...poseView,
    target: [place[0], place[1], place[2]],
    azimuth: Math.atan2(toViewer[0], toViewer[2]),
    elevation: Math.min(highest, Math.max(-highest, Math.asin(toViewer[1]))),
    distance: display.scale * distance,
  };
}

/** Turns directions as a transform does; what comes out has the length 1. */
function turning(transform: mat4): (direction: ReadonlyVec3) => vec3 {
  const rotation = mat3.fromMat4(new Float64Array(9), transform);
  return (direction) => {
    const turned = vec3.transformMat3(new Float64Array(3), direction, rotation);
    return vec3.normalize(turned, turned);
  };
}

/** Other directions from which a joint may be seen, in scene space: from all sides, on two heights. */
const around = [-0.3, 0.35].flatMap((elevation) =>
  Array.from({ length: 8 }, (_, i): vec3 => {
    const azimuth = (i * Math.PI) / 4 + 0.3;
    const across = Math.cos(elevation);
    return [across * Math.sin(azimuth), Math.sin(elevation), across * Math.cos(azimuth)];
  }),
);

/** From in front, from outside and from slightly above. */
function preferred(place: vec3): vec3 {
  const side = place[0] < -middle ? -1 : 1;
  const direction: vec3 = [side * 0.8, 0.35, 1];
  return vec3.normalize(direction, direction);
}

/** Along the axis of a bend, on the preferred side. */
function profile(axis: vec3, place: vec3): vec3 {
  const wanted = preferred(place);
  const side = vec3.dot(axis, wanted) < 0 ? -1 : 1;
  const direction = vec3.scale(new Float64Array(3), axis, side);
  vec3.scaleAndAdd(direction, direction, wanted, tilt);
  return vec3.normalize(direction, direction);
}

/** At a right angle to the axis of a twist. */
function beside(axis: vec3, place: vec3): vec3 {
  const wanted = preferred(place);
  vec3.scaleAndAdd(wanted, wanted, axis, -vec3.dot(wanted, axis));
  return vec3.normalize(wanted, wanted);
}
