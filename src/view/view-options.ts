import type { ActorId } from '../document/scene.ts';
import type {
  ActiveDof,
  HandleId,
  HoveredLimb,
  Light,
  PosesBy,
  Session,
  SkeletonStyle,
} from '../document/session.ts';

/** What is shown of the scene, in addition to the document. */
export interface ViewOptions {
  readonly showSkin: boolean;
  readonly showSkeleton: boolean;
  readonly skeletonStyle: SkeletonStyle;
  readonly showTextures: boolean;
  readonly showAxes: boolean;
  readonly translucent: boolean;
  /** Shows floor and backdrop; without them the picture is transparent around the characters. */
  readonly showStudio: boolean;
  readonly selectedActorId: ActorId | null;
  /** The selected joint of the selected actor, or null. */
  readonly selectedJoint: number | null;
  readonly hoveredLimb: HoveredLimb | null;
  /** Shows what belongs to the page and not to the picture: handles and the light on a limb. */
  readonly showOverlay: boolean;
  readonly hoveredHandle: HandleId | null;
  readonly activeDof: ActiveDof | null;
  readonly posesBy: PosesBy;
  readonly playing: boolean;
  readonly byTouch: boolean;
  /** The key, fill and rim lights. */
  readonly lights: readonly Light[];
}

/**
 * Returns the session's options, with the studio and the overlay shown. Reading subscribes to the
 * session.
 */
export function viewOptionsOf(session: Session): ViewOptions {
  return {
    showStudio: true,
    showSkin: session.showSkin.value,
    showSkeleton: session.showSkeleton.value,
    skeletonStyle: session.skeletonStyle.value,
    showTextures: session.showTextures.value,
    showAxes: session.showAxes.value,
    translucent: session.translucent.value,
    selectedActorId: session.selectedActorId.value,
    selectedJoint: session.selectedJoint.value,
    hoveredLimb: session.hoveredLimb.value,
    showOverlay: true,
    hoveredHandle: session.hoveredHandle.value,
    activeDof: session.activeDof.value,
    posesBy: session.posesBy.value,
    playing: session.playing.value,
    byTouch: session.byTouch.value,
    lights: session.lights.value,
  };
}
