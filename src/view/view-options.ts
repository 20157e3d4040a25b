import type { ChainLength } from '../posing/ik/chain.ts';
import type { WeightViewId } from '../skinning/weights/views.ts';
import type { IkSketch } from '../document/ik-sketch.ts';
import type { Environment } from '../document/environment.ts';
import type { ActorId, Scene } from '../document/scene.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import type {
  ActiveDof,
  HandleId,
  HoveredLimb,
  PlaceAxes,
  PlaceTool,
  PosesBy,
  Session,
  ShownChain,
  SkeletonStyle,
} from '../document/session.ts';

/** How the weights of the selected actor are shown in color. */
export interface WeightOptions {
  readonly view: WeightViewId;
  readonly unlit: boolean;
  /** The marked point of its mesh, or null. */
  readonly marked: number | null;
}

/** How the session views a scene. */
export interface SessionOptions {
  readonly showSkin: boolean;
  readonly showSkeleton: boolean;
  readonly skeletonStyle: SkeletonStyle;
  readonly showTextures: boolean;
  readonly showNormals: boolean;
  readonly showAxes: boolean;
  readonly weights: WeightOptions | null;
  readonly translucent: boolean;
  readonly selectedActorId: ActorId | null;
  /** The selected joint of the selected actor, or null. */
  readonly selectedJoint: number | null;
  /** All that are selected together, that one first. */
  readonly selectedJoints: readonly number[];
  /** Those that mirror the selected ones while live symmetry is on. */
  readonly mirroredJoints: readonly number[];
  readonly hoveredLimb: HoveredLimb | null;
  /** Shows what belongs to the page and not to the picture: handles and the light on a limb. */
  readonly showOverlay: boolean;
  readonly hoveredHandle: HandleId | null;
  readonly dragsLights: boolean;
  readonly activeDof: ActiveDof | null;
  readonly placeTool: PlaceTool | null;
  readonly placeAxes: PlaceAxes;
  readonly ringAxes: PlaceAxes;
  readonly posesBy: PosesBy;
  readonly playing: boolean;
  readonly ikMode: boolean;
  readonly chainLength: ChainLength | null;
  readonly shownChain: ShownChain | null;
  readonly showTargets: boolean;
  readonly byTouch: boolean;
  readonly ikSketch: IkSketch | null;
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
  return {
    showSkin: session.showSkin.value,
    showSkeleton: session.showSkeleton.value,
    skeletonStyle: session.skeletonStyle.value,
    showTextures: session.showTextures.value,
    showNormals: session.showNormals.value,
    showAxes: session.showAxes.value,
    weights: session.showWeights.value
      ? {
          view: session.weightView.value,
          unlit: session.unlitWeights.value,
          marked: session.markedPoint.value,
        }
      : null,
    translucent: session.translucent.value,
    selectedActorId: session.selectedActorId.value,
    selectedJoint: session.selectedJoint.value,
    selectedJoints: selectedJoints(session),
    mirroredJoints: session.mirroredJoints.value,
    hoveredLimb: session.hoveredLimb.value,
    showOverlay: true,
    hoveredHandle: session.hoveredHandle.value,
    dragsLights: session.dragsLights.value,
    activeDof: session.activeDof.value,
    placeTool: session.placeTool.value,
    placeAxes: session.placeAxes.value,
    ringAxes: session.ringAxes.value,
    posesBy: session.posesBy.value,
    playing: session.playing.value,
    ikMode: session.ikMode.value,
    chainLength: session.chainLength.value,
    shownChain: session.shownChain.value,
    showTargets: session.showTargets.value,
    byTouch: session.byTouch.value,
    ikSketch: session.ikSketch.value,
  };
}

/** Whether an actor shows its weights in color instead of its materials. */
export function showsWeights(id: ActorId, { weights, selectedActorId }: ViewOptions): boolean {
  return weights !== null && id === selectedActorId;
}
