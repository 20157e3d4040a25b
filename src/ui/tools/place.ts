import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import { movedBy, scaledBy, setTransform, snapped, turnedBy } from '../../document/place-edits.ts';
import type { Transform } from '../../document/scene.ts';
import type { PlaceAxes } from '../../document/session.ts';
import type { Ray } from '../../core/ray.ts';
import { ringTurn, seenRing } from '../../posing/ring-turn.ts';
import { slideOnLine, slideOnPlane } from '../../posing/slide.ts';
import { eyeOf } from '../../view/camera.ts';
import { pixelsIn } from '../../view/overlay.ts';
import { overlayViewAt, pixelsAt } from '../../view/overlay-place.ts';
import { bodyHandleAt, placeHandleAt } from '../../view/pick-gizmo.ts';
import { rayThrough } from '../../view/picking.ts';
import { axisOf, type PlaceHandle } from '../../view/place-gizmo.ts';
import type { Looking } from '../editor.ts';
import { showHoveredHandle } from '../hover.ts';
import { placeLabel, placeSteps } from '../place-steps.ts';
import { dragText, stepHint } from '../place-text.ts';
import {
  distanceBetween,
  fine,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from '../tool.ts';

/** A drag through the center does not make a character smaller than this part of its size. */
const leastFactor = 0.01;

/**
 * A left drag on a handle of the whole selected character moves, turns or scales it; while it is
 * being moved, the character itself is a handle too.
 */
export const placeTool: Tool = {
  id: 'place',
  poses: true,
  press(place, button, editor) {
    if (button !== 0) return null;
    const handle = placeHandleAt(editor, place) ?? bodyHandleAt(editor, place);
    if (!handle) return null;
    showHoveredHandle(editor, handle.id);
    return placeBy(editor, place, handle);
  },
};

/** The keys that are held during a drag, and the axes that it is about. */
interface Manner {
  readonly axes: PlaceAxes;
  /** Whether amounts are rounded to steps. */
  readonly steps: boolean;
  /** A factor for what the pointer does. */
  readonly part: number;
}

/** Returns the transform after a drag from one place to another; null if it leads nowhere. */
type Change = (
  start: Transform,
  from: ToolPlace,
  to: ToolPlace,
  manner: Manner,
) => Transform | null;

/**
 * A drag depends only on its start. When Shift is pressed or released, it starts again from the
 * transform of that moment.
 */
function placeBy(editor: Looking, pressed: ToolPlace, handle: PlaceHandle): ToolDrag {
  const { store, session } = editor;
  const actor = editor.evaluations.selected()!.state;
  const axes = session.placeAxes.value;
  const change = changeOf(editor, pressed, handle);
  const tool = session.placeTool.value!;
  const label = placeLabel(tool, actor);
  const gesture = store.begin(label);
  const first = actor.transform;
  let present = first;
  let start = { transform: present, at: pressed };
  let moved = false;
  const finish = (end: () => void): void => {
    end();
    session.dragText.value = null;
  };

  return {
    move({ place: to }) {
      moved ||= distanceBetween(pressed, to) > stillDistance;
      // After the drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (!gesture.isOpen) session.dragText.value = null;
      if (!moved || !gesture.isOpen) return;
      if (to.shift !== start.at.shift) start = { transform: present, at: to };
      const manner = { axes, steps: to.control, part: to.shift ? fine : 1 };
      present = change(start.transform, start.at, to, manner) ?? present;
      const text = dragText(handle, axes, first, present);
      const hint = session.byTouch.value ? '' : stepHint(tool, to.control);
      session.dragText.value = `${text}${hint}`;
      gesture.preview(setTransform(actor.id, present, label));
    },
    end: () => finish(() => gesture.commit()),
    cancel: () => finish(() => gesture.cancel()),
  };
}

function changeOf(editor: Looking, pressed: ToolPlace, handle: PlaceHandle): Change {
  if (handle.kind === 'ring') return turnOf(editor, pressed, handle);
  if (handle.kind === 'size') return sizeOf(editor, pressed, handle);
  return slideOf(editor, handle);
}

/** Moves along a line or on a plane. */
function slideOf({ viewer }: Looking, { kind, axis, center, direction }: PlaceHandle): Change {
  const { camera, aspect } = { camera: viewer.camera.value, aspect: viewer.aspect };
  const rayAt = ({ x, y }: ToolPlace): Ray => rayThrough(camera, aspect, x, y);
  return (start, from, to, { axes, steps, part }) => {
    const rays = [rayAt(from), rayAt(to)] as const;
    const grid = steps ? placeSteps.move : 0;
    const moved = (parts: readonly (readonly [ReadonlyVec3, number])[]): Transform => {
      const vector = new Float64Array(3);
      for (const [unit, amount] of parts) {
        // The scene's axes have a grid in common; a character's own axes begin where it stands.
        const own = axes === 'local' && steps ? snapped(amount * part, grid) : amount * part;
        vec3.scaleAndAdd(vector, vector, unit, own);
      }
      return movedBy(start, vector, axes === 'world' ? grid : 0);
    };
    if (kind === 'line') {
      const amount = slideOnLine(center, direction, ...rays);
      return amount === null ? null : moved([[direction, amount]]);
    }
    const vector = slideOnPlane(center, direction, ...rays);
    if (!vector) return null;
    if (axis === null) return movedBy(start, vec3.scale(vector, vector, part), grid);
    // Made of the two axes of the plane, so that the third coordinate keeps its bits.
    const units = [(axis + 1) % 3, (axis + 2) % 3].map((each) =>
      axisOf(start, axes, each as 0 | 1 | 2),
    );
    return moved(units.map((unit) => [unit, vec3.dot(vector, unit)] as const));
  };
}

function turnOf(editor: Looking, pressed: ToolPlace, handle: PlaceHandle): Change {
  const view = overlayViewAt(editor, pressed);
  const seen = seenRing(handle, eyeOf(editor.viewer.camera.value), pixelsIn(view));
  let turn = 0;
  let startOfTurn: Transform | null = null;
  return (start, from, to, { axes, steps, part }) => {
    if (start !== startOfTurn) [startOfTurn, turn] = [start, 0];
    turn = ringTurn(seen, pixelsAt(view, from), pixelsAt(view, to), turn);
    const angle = steps ? snapped(turn * part, placeSteps.turn) : turn * part;
    return turnedBy(start, axisOf(start, 'world', handle.axis!), angle, axes === 'local');
  };
}

/** Scales by how far the pointer is from the center, in the direction in which it was at first. */
function sizeOf(editor: Looking, pressed: ToolPlace, { center }: PlaceHandle): Change {
  const view = overlayViewAt(editor, pressed);
  const [centerX, centerY] = pixelsIn(view)(center);
  return (start, from, to, { steps, part }) => {
    const [[fromX, fromY], [toX, toY]] = [from, to].map((place) => {
      const [x, y] = pixelsAt(view, place);
      return [x - centerX, y - centerY] as const;
    }) as [readonly [number, number], readonly [number, number]];
    const squared = fromX * fromX + fromY * fromY;
    if (squared === 0) return null;
    const factor = Math.max(leastFactor, (fromX * toX + fromY * toY) / squared);
    return scaledBy(start, 1 + (factor - 1) * part, steps ? placeSteps.scale : 0);
  };
}
