import { vec3 } from 'gl-matrix';
import { type Bounds, emptyBounds, includePositions } from '../../core/bounds.ts';
import type { Camera } from '../../document/camera.ts';
import { studio } from '../../document/environment.ts';
import { type Actor, createActor } from '../../document/scene.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { sceneBounds } from '../../evaluation/scene-bounds.ts';
import { frameBox, startCamera } from '../camera.ts';
import type { ViewOptions } from '../view-options.ts';
import type { Viewer } from '../viewer.ts';
import { averageSamples } from './average-samples.ts';
import type { Picture } from './encode-picture.ts';
import { drawApart } from './held-moment.ts';
import { captureFrame } from './make-picture.ts';

/** Samples on each side of a pixel: small pictures show jagged edges most. */
const samples = 2;

/** No actor of a scene has it. */
const pictureId = -1;

/** From the right of the front, slightly above, with a long lens. */
export const poseView: Camera = {
  ...startCamera,
  azimuth: 0.45,
  elevation: 0.12,
  fieldOfView: 0.35,
};

/** The camera that frames a pose in a square. */
export function poseCamera(box: Bounds): Camera {
  return frameBox(poseView, box, 1);
}

/**
 * Draws a character alone in a pose, without a background, in the light of a new scene, whatever the
 * page shows. The viewer must be `available`.
 *
 * @param actor in the pose; its place in the scene does not count
 * @param joints those that the picture shows; the whole character, if none are given
 * @param side of the square, in pixels
 */
export function posePicture(
  viewer: Viewer,
  actor: Actor,
  joints: readonly number[],
  side: number,
): Picture {
  const cameraOf = (still: Evaluation): Camera =>
    poseCamera(joints.length > 0 ? partBounds(still, joints) : sceneBounds([still]));
  return actorPicture(viewer, actor, cameraOf, side);
}

/**
 * Draws the same from another camera.
 *
 * @param cameraOf gives the camera for the character as it is drawn
 */
export function actorPicture(
  viewer: Viewer,
  actor: Actor,
  cameraOf: (still: Evaluation) => Camera,
  side: number,
): Picture {
  const { character, method, q, morphWeights, methodSettings } = actor;
  const { normals, normalizeWeights, influences, skin } = actor;
  const look = { ...actor.look, visible: true };
  const alone = createActor(pictureId, character, method, {
    ...{ q, morphWeights, methodSettings, normals, normalizeWeights, influences, skin, look },
  });
  const still = viewer.evaluations.of(alone).still();
  viewer.held.add(still);
  try {
    const viewport = { x: 0, y: 0, width: side * samples, height: side * samples };
    const options = plainOptions(character.mesh.pointCount > 0);
    const view = { camera: cameraOf(still), viewport, overrides: {} };
    const pixels = drawApart(viewer, view, [still], options, captureFrame);
    const goal = { width: side, height: side, pixels: new Uint8ClampedArray(side * side * 4) };
    averageSamples({ ...viewport, pixels }, samples, goal, 0, 0);
    return goal;
  } finally {
    viewer.held.delete(still);
    still.dispose();
    viewer.requestFrame(); // drawing of any kind empties the canvas
  }
}

/** How much of a character's height is shown around the joints of a part. */
const aroundJoints = 0.06;

/** The box around some joints and those that follow them, in scene space. */
function partBounds(
  { state, characterFromJoint, display }: Evaluation,
  joints: readonly number[],
): Bounds {
  const box = emptyBounds();
  const { parents } = state.character.skeleton;
  const shown = new Set(joints);
  parents.forEach((parent, joint) => {
    if (!shown.has(joint) && !shown.has(parent)) return;
    const place = characterFromJoint.subarray(joint * 16 + 12, joint * 16 + 15);
    const point = vec3.transformMat4(new Float64Array(3), place, display.sceneFromCharacter);
    includePositions(box, point, 1);
  });
  return {
    min: box.min.map((value) => value - aroundJoints),
    max: box.max.map((value) => value + aroundJoints),
  };
}

/** A skin alone, or a skeleton where there is none, with nothing of the page. */
function plainOptions(hasSkin: boolean): Partial<ViewOptions> {
  return {
    environment: studio,
    ...{ showSurroundings: false, showSkin: true, showTextures: true, showSkeleton: !hasSkin },
    ...{ skeletonStyle: 'sticks', showAxes: false, showNormals: false, translucent: false },
    ...{ weights: null, selectedActorId: null, selectedJoint: null, hoveredLimb: null },
  };
}
