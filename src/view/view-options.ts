import type { ActorId } from '../document/scene.ts';
import {
  type HandleId,
  handleOf,
  type HoveredLimb,
  type Light,
  type Session,
  type SkeletonStyle,
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
  /** The rings at the selected joint, if they are shown. */
  readonly gizmo: Gizmo | null;
  /** The key, fill and rim lights. */
  readonly lights: readonly Light[];
}

/** How the rings at the selected joint look. */
export interface Gizmo {
  /** In CSS pixels. */
  readonly radius: number;
  readonly hovered: HandleId | null;
  /** The handle of the active degree of freedom. */
  readonly active: HandleId | null;
}

/** In CSS pixels: for a mouse, and for fingers. */
const [ringRadius, touchRingRadius] = [70, 96];

/** Returns the session's options, with the studio and the overlay shown. Reading subscribes to the session. */
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
    gizmo: gizmoOf(session),
    lights: session.lights.value,
  };
}

/**
 * Rings are shown where the selected joint can be posed by them, and not while it moves by itself.
 */
function gizmoOf(session: Session): Gizmo | null {
  const { posesBy, playing, selectedJoint, hoveredHandle, activeDof, byTouch } = session;
  if (posesBy.value === 'mode' || playing.value || selectedJoint.value === null) return null;
  return {
    radius: byTouch.value ? touchRingRadius : ringRadius,
    hovered: hoveredHandle.value,
    active: activeDof.value && handleOf(activeDof.value),
  };
}
