import { mat4, type ReadonlyVec3, vec3 } from 'gl-matrix';
import type { Ray } from '../../core/ray.ts';
import { setPose } from '../../document/edits.ts';
import { snapped } from '../../document/place-edits.ts';
import type { Vector3 } from '../../posing/ik/problem.ts';
import { slideJoint } from '../../posing/slide-joint.ts';
import { slideOnLine, slideOnPlane } from '../../posing/slide.ts';
import type { MoveHandle } from '../../view/move-gizmo.ts';
import { moveHandleAt } from '../../view/pick-gizmo.ts';
import { rayThrough } from '../../view/picking.ts';
import type { Looking, Telling } from '../editor.ts';
import { holdChain } from '../hold-chain.ts';
import { showHoveredHandle } from '../hover.ts';
import { axisNames } from '../joint-values.ts';
import { fixedText } from '../number-text.ts';
import {
  distanceBetween,
  fine,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** With Ctrl or Cmd, in scene units. */
const snapStep = 0.05;

/**
 * A left drag on an arrow, a square or the ring of the selected joint moves the target of its chain
 * or, without inverse kinematics, its slides.
 */
export const moveJointTool: Tool = {
  id: 'move-joint',
  poses: true,
  press(place, button, editor) {
    const handle = button === 0 ? moveHandleAt(editor, place) : null;
    if (!handle) return null;
    showHoveredHandle(editor, handle.id);
    return moveBy(editor, place, handle);
  },
};

/** What a drag moves, by a vector of the character's space from where it was at the press. */
interface Moved {
  readonly isOpen: boolean;
  moveBy(vector: Vector3, text: string): void;
  /** Adds joints to the chain, if there is one, or takes some from it. */
  lengthen?(step: number): void;
  end(): void;
  cancel(): void;
}

/**
 * A drag depends only on its start. When Shift is pressed or released, it starts again from the
 * place of that moment.
 */
function moveBy(editor: Looking & Telling, pressed: ToolPlace, handle: MoveHandle): ToolDrag {
  const { display } = editor.evaluations.selected()!;
  const characterFromScene = mat4.invert(new Float64Array(16), display.sceneFromCharacter)!;
  const moved = handle.isTarget ? moveTarget(editor, handle) : moveSlides(editor, handle);
  let present: ReadonlyVec3 = [0, 0, 0];
  let start = { vector: present, at: pressed };
  let isDragged = false;

  return {
    move({ place: to }) {
      isDragged ||= distanceBetween(pressed, to) > stillDistance;
      if (!isDragged || !moved.isOpen) return;
      if (to.shift !== start.at.shift) start = { vector: present, at: to };
      const by = vectorOf(editor, handle, start.at, to);
      if (!by) return;
      present = vec3.scaleAndAdd(new Float64Array(3), start.vector, by, to.shift ? fine : 1);
      const shown = to.control ? onGrid(handle, present) : present;
      moved.moveBy(inCharacter(shown), textOf(handle, shown));
    },
    wheel: (step) => moved.lengthen?.(step),
    end: () => moved.end(),
    cancel: () => moved.cancel(),
  };

  function inCharacter(vector: ReadonlyVec3): Vector3 {
    const at = (place: ReadonlyVec3): vec3 =>
      vec3.transformMat4(new Float64Array(3), place, characterFromScene);
    const tip = at(vector);
    vec3.subtract(tip, tip, at([0, 0, 0]));
    return [tip[0], tip[1], tip[2]];
  }
}

/** The vector in the scene by which a handle is dragged from one place of the view to another. */
function vectorOf(
  { viewer }: Looking,
  { kind, center, direction }: MoveHandle,
  from: ToolPlace,
  to: ToolPlace,
): ReadonlyVec3 | null {
  const rayAt = ({ x, y }: ToolPlace): Ray =>
    rayThrough(viewer.viewCamera.value, viewer.aspect, x, y);
  if (kind !== 'line') return slideOnPlane(center, direction, rayAt(from), rayAt(to));
  const amount = slideOnLine(center, direction, rayAt(from), rayAt(to));
  return amount === null ? null : vec3.scale(new Float64Array(3), direction, amount);
}

/** The vector in whole steps along the handle's axes. */
function onGrid({ kind, direction, first, second }: MoveHandle, vector: ReadonlyVec3): vec3 {
  const axes = kind === 'line' ? [direction] : [first, second];
  const sum = new Float64Array(3);
  for (const axis of axes) {
    const unit = vec3.normalize(new Float64Array(3), axis);
    vec3.scaleAndAdd(sum, sum, unit, snapped(vec3.dot(vector, unit), snapStep));
  }
  return sum;
}

function textOf({ kind, axis, direction }: MoveHandle, vector: ReadonlyVec3): string {
  if (kind === 'line') return `${axisNames[axis!]} ${fixedText(vec3.dot(vector, direction))}`;
  return Array.from(vector, (value, i) => `${axisNames[i as 0 | 1 | 2]} ${fixedText(value)}`)
    .filter((_, i) => i !== axis)
    .join(', ');
}

function moveTarget(editor: Looking & Telling, { joint, point, center }: MoveHandle): Moved {
  const { display, state } = editor.evaluations.selected()!;
  const characterFromScene = mat4.invert(new Float64Array(16), display.sceneFromCharacter)!;
  const first = vec3.transformMat4(new Float64Array(3), center, characterFromScene);
  const name = state.character.skeleton.names[joint]!;
  const held = holdChain(editor, { joint, point, name, label: `Move ${name}` });
  return {
    get isOpen() {
      return held.isOpen;
    },
    moveBy: ([x, y, z]) => held.aim([first[0] + x, first[1] + y, first[2] + z]),
    lengthen: (step) => held.lengthen(step),
    end: () => held.end(),
    cancel: () => held.cancel(),
  };
}

function moveSlides({ store, session, evaluations }: Looking, { joint }: MoveHandle): Moved {
  const { state, poseToEdit } = evaluations.selected()!;
  const { skeleton } = state.character;
  const name = skeleton.names[joint]!;
  const label = `Move ${name}`;
  const q = poseToEdit.q.slice();
  const gesture = store.begin(label);
  const finish = (end: () => void): void => {
    end();
    session.dragText.value = null;
  };
  return {
    get isOpen() {
      return gesture.isOpen;
    },
    moveBy(vector, text) {
      gesture.preview(setPose(state.id, slideJoint(skeleton, q, joint, vector), label));
      session.dragText.value = `${name} moved ${text}`;
    },
    end: () => finish(() => gesture.commit()),
    cancel: () => finish(() => gesture.cancel()),
  };
}
