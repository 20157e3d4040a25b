import type { BoneTarget } from '../view/pick.ts';
import type { Looking } from './editor.ts';
import type { ToolPlace } from './tool.ts';

/** Highlights the joint and bone under the pointer, or nothing. */
export function showHover(
  { session }: Looking,
  place: ToolPlace | null,
  target: BoneTarget | null,
): void {
  session.hoveredJoint.value = target?.joint ?? null;
  session.hoveredBone.value = target?.bone ?? null;
  session.hoverPlace.value = place && target ? [place.pixelX, place.pixelY] : null;
}
