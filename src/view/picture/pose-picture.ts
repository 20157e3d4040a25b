import { vec3 } from 'gl-matrix';
import { type Bounds, emptyBounds, includePositions } from '../../core/bounds.ts';
import type { Camera } from '../../document/camera.ts';
import { studio } from '../../document/environment.ts';
import { type Actor, createActor } from '../../document/scene.ts';
import type { Evaluation, StillEvaluation } from '../../evaluation/evaluation.ts';
import { sceneBounds } from '../../evaluation/scene-bounds.ts';
import { frameBox, startCamera } from '../camera.ts';
import type { Frame } from '../frame.ts';
import type { Renderer } from '../renderer.ts';
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
  const held = holdAlone(viewer, actor);
  const { still } = held;
  try {
    const camera = poseCamera(joints.length > 0 ? partBounds(still, joints) : sceneBounds([still]));
    return averaged(drawAlone(viewer, still, camera, side, captureFrame), side);
  } finally {
    held.release();
  }
}

/** A character alone, which keeps its objects on the GPU until it is released. */
export interface HeldAlone {
  readonly still: StillEvaluation;
  release(): void;
}

/** @param actor in the pose; its place in the scene does not count */
export function holdAlone(viewer: Viewer, actor: Actor): HeldAlone {
  const { character, method, q, morphWeights, methodSettings } = actor;
  const { normals, normalizeWeights, influences, skin } = actor;
  const look = { ...actor.look, visible: true };
  const alone = createActor(pictureId, character, method, {
    ...{ q, morphWeights, methodSettings, normals, normalizeWeights, influences, skin, look },
  });
  const still = viewer.evaluations.of(alone).still();
  viewer.held.add(still);
  const release = (): void => {
    viewer.held.delete(still);
    still.dispose();
    viewer.requestFrame(); // drawing of any kind empties the canvas
  };
  return { still, release };
}

/** Draws what is held as `posePicture` does, with as many samples as `averaged` takes. */
export function drawAlone<Result>(
  viewer: Viewer,
  still: StillEvaluation,
  camera: Camera,
  side: number,
  draw: (renderer: Renderer, frame: Frame) => Result,
): Result {
  const viewport = { x: 0, y: 0, width: side * samples, height: side * samples };
  const options = plainOptions(still.state.character.mesh.pointCount > 0);
  return drawApart(viewer, { camera, viewport, overrides: {} }, [still], options, draw);
}

/** The picture of a square's samples. */
export function averaged(pixels: Uint8Array, side: number): Picture {
  const size = side * samples;
  const goal = { width: side, height: side, pixels: new Uint8ClampedArray(side * side * 4) };
  averageSamples({ width: size, height: size, pixels }, samples, goal, 0, 0);
  return goal;
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
