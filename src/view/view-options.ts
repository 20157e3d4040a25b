import type { WeightViewId } from '../skinning/weights/views.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Environment } from '../document/environment.ts';
import type { ActorId, Scene } from '../document/scene.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import type { Session } from '../document/session.ts';

/** How the weights of the selected actor are shown in color, or what is painted on every actor. */
export interface WeightOptions {
  readonly view: WeightViewId;
  readonly unlit: boolean;
  /** The marked point of its mesh, or null. */
  readonly marked: number | null;
  /**
   * Returns the colors to show in their place: (vertexCount × 4) sRGB bytes, the same array until they
   * change.
   */
  readonly paint?: (evaluation: Evaluation) => Uint8Array;
}

/** What a picture depends on and the session has as it is. */
const plainOptions = [
  'showSkin',
  'showSkeleton',
  'skeletonStyle',
  'showTextures',
  'showNormals',
  'showAxes',
  'translucent',
  'selectedActorId',
  'selectedJoint',
  'mirroredJoints',
  'hoveredLimb',
  'hoveredHandle',
  'dragsLights',
  'activeDof',
  'placeTool',
  'placeAxes',
  'ringAxes',
  'posesBy',
  'playing',
  'ikMode',
  'chainLength',
  'shownChain',
  'showTargets',
  'byTouch',
  'ikSketch',
  'cutSketch',
  'rotationPaths',
] as const;

type PlainOptions = {
  readonly [Key in (typeof plainOptions)[number]]: Session[Key]['value'];
};

/** How the session views a scene. */
export interface SessionOptions extends PlainOptions {
  readonly weights: WeightOptions | null;
  /** All joints that are selected together, the selected one first. */
  readonly selectedJoints: readonly number[];
  /** Shows what belongs to the page and not to the picture: handles and the light on a limb. */
  readonly showOverlay: boolean;
}

/** Everything besides the actors that a picture depends on. */
export interface ViewOptions extends SessionOptions {
  readonly environment: Environment;
  /** Whether any character has pins or targets to show. */
  readonly hasHandles: boolean;
  /** Shows floor and background; without them the picture is transparent around the characters. */
  readonly showSurroundings: boolean;
}

/** Returns the options of a scene as the session views it. Reading subscribes to the session. */
export function viewOptionsOf(session: Session, { environment, actors }: Scene): ViewOptions {
  const hasHandles = actors.some(({ pins, character }) => pins[0] ?? character.ikChains[0]);
  return { ...sessionOptionsOf(session), environment, hasHandles, showSurroundings: true };
}

/**
 * Returns the session's options, with the overlay shown. Reading subscribes to the session.
 */
export function sessionOptionsOf(session: Session): SessionOptions {
  const { showWeights, weightView, unlitWeights, markedPoint } = session;
  const plain = Object.fromEntries(plainOptions.map((key) => [key, session[key].value]));
  return {
    ...(plain as unknown as PlainOptions),
    weights: showWeights.value
      ? { view: weightView.value, unlit: unlitWeights.value, marked: markedPoint.value }
      : null,
    selectedJoints: selectedJoints(session),
    showOverlay: true,
  };
}

/** Whether an actor shows its weights, or what is painted in their place, instead of its materials. */
export function showsWeights(id: ActorId, { weights, selectedActorId }: ViewOptions): boolean {
  return weights !== null && (weights.paint !== undefined || id === selectedActorId);
}
