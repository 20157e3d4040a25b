import { mat3, mat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import { sizeOf } from '../../evaluation/comparison/difference.ts';
import { jointReach } from '../../evaluation/comparison/joint-reach.ts';
import type { StressPose } from '../../evaluation/comparison/stress-poses.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { limbEnd } from '../../posing/telling-poses.ts';
import { halfHeightOf } from '../camera.ts';
import { poseView } from './pose-picture.ts';

/** The least and the most that is shown around a joint, in heights of the character. */
const [nearest, farthest] = [0.06, 0.4];
/** The room around what bends with a joint, as a factor. */
const margin = 1.4;
/** How much a profile is seen from the preferred side, and how far an eye rises, in radians. */
const [tilt, highest] = [0.5, 1.1];
/** So near to the middle of the scene, a joint is on no side. */
const middle = 0.01;
/** An axis that has this cosine with the bone twists it. */
const along = 0.8;

/**
 * The camera that shows what a joint does to the skin around it, near enough to see it: a bend in
 * profile, a twist from the side of the bone, both from in front and from outside of the body.
 *
 * @param evaluation of the pose
 */
export function jointCamera(evaluation: Evaluation, { joint, axis }: StressPose): Camera {
  const { state, skin, characterFromJoint, display } = evaluation;
  const { height } = sizeOf(state.character);
  const sceneFromJoint = mat4.multiply(
    new Float64Array(16),
    display.sceneFromCharacter,
    characterFromJoint.subarray(joint * 16, joint * 16 + 16),
  );
  const rotation = mat3.fromMat4(new Float64Array(9), sceneFromJoint);
  const inScene = (direction: ReadonlyVec3): vec3 => {
    const turned = vec3.transformMat3(new Float64Array(3), direction, rotation);
    return vec3.normalize(turned, turned);
  };
  const place = mat4.getTranslation(new Float64Array(3), sceneFromJoint);
  const [turn, bone] = [inScene(axis), inScene(limbEnd(state.character, joint))];
  const toViewer =
    Math.abs(vec3.dot(turn, bone)) > along ? beside(turn, place) : profile(turn, place);
  const reach = margin * jointReach(state.character, skin, joint);
  const shown = display.scale * Math.min(farthest * height, Math.max(nearest * height, reach));
  return {
    ...poseView,
    target: [place[0], place[1], place[2]],
    azimuth: Math.atan2(toViewer[0], toViewer[2]),
    elevation: Math.min(highest, Math.max(-highest, Math.asin(toViewer[1]))),
    distance: shown / halfHeightOf({ ...poseView, distance: 1 }),
  };
}

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
