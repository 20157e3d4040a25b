import { rayInFrame } from '../../core/ray.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { slideOnPlane } from '../../posing/slide.ts';
import { axesOf } from '../../view/camera.ts';
import { boneAt, characterRayAt } from '../../view/pick.ts';
import type { Looking, Telling } from '../editor.ts';
import { holdChain } from '../hold-chain.ts';
import { showHover } from '../hover.ts';
import { anyIsLive, isLive } from '../live-limb.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/**
 * With inverse kinematics, or with Shift for one drag, a left drag on the selected limb moves its
 * chain, in bone mode that of any limb.
 */
export const ikTool: Tool = {
  id: 'ik',
  poses: true,
  press(place, button, editor) {
    const { ikMode } = editor.session;
    const isAsked = button === 0 && (ikMode.value || place.shift);
    if (!isAsked || !anyIsLive(editor.session)) return null;
    const target = boneAt(editor, place);
    if (!target || !isLive(editor, target)) return null;
    showHover(editor, place, target);
    return dragLimb(editor, place, target.joint, target.grabbed);
  },
};

/**
 * The grabbed point goes on the plane through it that faces the camera, as far as the pointer goes,
 * also beyond the view's edge.
 */
export function dragLimb(
  editor: Looking & Telling,
  from: ToolPlace,
  joint: number,
  grabbed: Vector3,
): ToolDrag {
  const { session, evaluations, viewer } = editor;
  const { state, characterFromJoint, display } = evaluations.selected()!;
  const limb = state.character.skeleton.names[joint]!;
  const point = inJoint(characterFromJoint, joint, grabbed);
  const held = holdChain(editor, { joint, point, name: limb, label: `Drag ${limb}` });
  const { look } = axesOf(viewer.viewCamera.value);
  const across = rayInFrame({ origin: [0, 0, 0], direction: look }, display.sceneFromCharacter);
  const start = characterRayAt(editor, from);
  let moved = false;

  return {
    move({ place }) {
      moved ||= distanceBetween(from, place) > stillDistance;
      if (!moved || !held.isOpen) return;
      session.hoverPlace.value = null;
      const ray = characterRayAt(editor, place);
      const by = slideOnPlane([...grabbed], across.direction, start, ray);
      if (by) held.aim([grabbed[0] + by[0], grabbed[1] + by[1], grabbed[2] + by[2]]);
    },
    wheel: (step) => held.lengthen(step),
    end: () => held.end(),
    cancel: () => held.cancel(),
  };
}

function inJoint(matrices: Float64Array, joint: number, [x, y, z]: Vector3): Vector3 {
  const matrix = matrices.subarray(joint * 16, joint * 16 + 16);
  const { origin } = rayInFrame({ origin: [x, y, z], direction: [0, 0, 1] }, matrix);
  return [origin[0], origin[1], origin[2]];
}
