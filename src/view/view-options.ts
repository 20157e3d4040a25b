import type { Bone } from '../core/bones.ts';
import type { ActorId } from '../document/scene.ts';
import type { Light, Session, SkeletonStyle } from '../document/session.ts';

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
  readonly hoveredJoint: number | null;
  /** The hovered bone, one of the selected character's own, or null. */
  readonly hoveredBone: Bone | null;
  /** The key, fill and rim lights. */
  readonly lights: readonly Light[];
}

/** Returns the session's options, with the studio shown. Reading subscribes to the session. */
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
    hoveredJoint: session.hoveredJoint.value,
    hoveredBone: session.hoveredBone.value,
    lights: session.lights.value,
  };
}
