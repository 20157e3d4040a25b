import { zoom } from '../view/camera.ts';
import { selectActor } from '../document/reconcile.ts';
import { selectJoint, toggleJoint } from '../document/select-joints.ts';
import { boneAt } from '../view/pick.ts';
import { pinAt } from '../view/pick-pin.ts';
import { handleAt } from '../view/pick-gizmo.ts';
import { pointAt } from '../view/pick-point.ts';
import type { Looking, Telling } from './editor.ts';
import { hoverAt, showHover, weightPointAt } from './hover.ts';
import { onceAFrame } from './once-a-frame.ts';
import {
  distanceBetween,
  stillDistance,
  type Tool,
  type ToolDrag,
  type ToolPlace,
} from './tool.ts';
import { tools } from './tools/registry.ts';

const zoomPerWheelPixel = 0.0012;
const pixelsPerLine = 24;
/** How far the wheel turns for one step of a drag. */
const pixelsPerStep = 40;
const panButton = 1;
const mouseTolerance = 6;
const touchTolerance = 20;

/** A press needs no outline of what has the focus; keys show it. Not every browser knows this. */
const withoutRing: FocusOptions & { readonly focusVisible: boolean } = {
  ...{ preventScroll: true, focusVisible: false },
};

/**
 * Sends drags on the canvas to the first tool that accepts them, and the wheel to the camera.
 * Hovering lights a limb, a click selects it, with Shift besides the others, and a click beside all
 * limbs deselects them. One finger
 * drags like the left button. Two fingers pan with their midpoint and zoom with their distance,
 * whatever the first finger had begun.
 */
export function listenToPointer(canvas: HTMLCanvasElement, editor: Looking & Telling): void {
  const { camera } = editor.viewer;
  const { session } = editor;
  const places = new Map<number, ToolPlace>();
  /** The view in which a drag began; it stays the drag's, wherever the pointer goes. */
  let column = 0;
  let drag: ToolDrag | null = null;
  let tool: Tool | null = null;
  let pressed: ToolPlace | null = null;
  /** How far the wheel has turned since the last step of a drag. */
  let turned = 0;
  // Picking tests triangles, so that one pick a frame is enough.
  const hover = onceAFrame((place: ToolPlace | null) => {
    if (places.size === 0) hoverAt(editor, place);
  });

  canvas.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && places.size > 0) return;
    if (places.size === 0) column = columnAt(event, canvas, editor.viewer);
    const place = placeOf(event, canvas, editor.viewer, column);
    places.set(event.pointerId, place);
    canvas.setPointerCapture(event.pointerId);
    canvas.focus(withoutRing);
    event.preventDefault();
    session.byTouch.value = event.pointerType === 'touch';
    const isFirst = places.size === 1;
    if (!isFirst) drag?.cancel();
    [tool, drag] = press(place, isFirst ? event.button : panButton);
    pressed = isFirst && event.button === 0 ? place : null;
  });
  canvas.addEventListener('pointermove', (event) => {
    const isHeld = places.has(event.pointerId);
    const place = placeOf(event, canvas, editor.viewer, isHeld ? column : undefined);
    if (!isHeld) {
      hover(place);
      return;
    }
    if (pressed && distanceBetween(pressed, place) > stillDistance) pressed = null;
    if (!pressed && !tool?.poses) showHover(editor, null, null);
    const [oldMiddle, oldSpread] = gather(places);
    places.set(event.pointerId, place);
    const [middle, spread] = gather(places);
    const [deltaX, deltaY] = [middle.x - oldMiddle.x, middle.y - oldMiddle.y];
    drag?.move({ place, deltaX, deltaY });
    if (places.size > 1 && spread > 0) camera.value = zoom(camera.value, oldSpread / spread);
  });
  canvas.addEventListener('pointerup', (event) => {
    if (!places.delete(event.pointerId)) return;
    drag?.end();
    drag = null;
    const place = placeOf(event, canvas, editor.viewer, column);
    if (pressed) click(place);
    pressed = null;
    hover(session.byTouch.value ? null : place);
  });
  canvas.addEventListener('pointercancel', (event) => {
    places.delete(event.pointerId);
    drag?.cancel();
    drag = null;
    pressed = null;
  });
  canvas.addEventListener('pointerleave', () => hover(null));
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * pixelsPerLine;
      if (drag?.wheel) {
        turned += pixels;
        // A notch of a wheel is one step at once, and a touchpad's many small turns make one.
        if (Math.abs(turned) < pixelsPerStep) return;
        drag.wheel(turned < 0 ? 1 : -1);
        turned = 0;
        return;
      }
      camera.value = zoom(camera.value, Math.exp(pixels * zoomPerWheelPixel));
      hover(placeOf(event, canvas, editor.viewer));
    },
    { passive: false },
  );

  function press(place: ToolPlace, button: number): [Tool, ToolDrag] | [null, null] {
    for (const each of tools) {
      const begun = each.press(place, button, editor);
      if (begun) return [each, begun];
    }
    return [null, null];
  }

  function click(place: ToolPlace): void {
    const pin = pinAt(editor, place);
    if (pin) {
      selectActor(session, editor.store.scene.value, pin.actorId);
      session.selectedJoint.value = pin.joint;
      return;
    }
    if (handleAt(editor, place) !== null) return;
    const target = boneAt(editor, place);
    const { activeDof, placeTool, selectsSeveral } = session;
    const isOneMore = place.shift || selectsSeveral.value;
    // A press beside all limbs is then most likely a miss.
    if (isOneMore && !target) return;
    if (target) selectActor(session, editor.store.scene.value, target.actorId);
    // A click on the selected limb lets all of its angles turn again.
    activeDof.value = null;
    // A tool for whole characters stays with them.
    const joint = placeTool.value === null ? (target?.joint ?? null) : null;
    if (isOneMore && joint !== null) toggleJoint(session, joint);
    else selectJoint(session, joint);
    session.markedPoint.value = weightPointAt(editor, place, target);
    // A click beside the skin keeps the inspected vertex.
    const { inspectedPoint } = session;
    if (inspectedPoint.value !== null)
      inspectedPoint.value = pointAt(editor, place) ?? inspectedPoint.value;
  }
}

/** Which of the views that are side by side an event is over, from the left. */
function columnAt(
  { clientX }: MouseEvent,
  canvas: HTMLCanvasElement,
  { columns }: Looking['viewer'],
): number {
  const { left, width } = canvas.getBoundingClientRect();
  const column = Math.floor(((clientX - left) / width) * columns);
  return Math.min(columns - 1, Math.max(0, column));
}

/** @param column the view of which the place is, even if it is outside of it */
function placeOf(
  event: PointerEvent | WheelEvent,
  canvas: HTMLCanvasElement,
  viewer: Looking['viewer'],
  column = columnAt(event, canvas, viewer),
): ToolPlace {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const [pixelX, pixelY] = [event.clientX - left, event.clientY - top];
  const { columns } = viewer;
  const parts = viewer.parts.peek();
  // Views side by side each have their own left and right edge.
  const each = width / columns;
  const isTouch = event instanceof PointerEvent && event.pointerType === 'touch';
  const within = pixelX - each * column;
  const wiped = parts.find(({ span }) => span && pixelX < span[1] * width);
  const { overrides } = wiped ?? parts[column] ?? {};
  return {
    x: (within / each) * 2 - 1,
    y: 1 - (pixelY / height) * 2,
    pixelX,
    pixelY,
    tolerance: isTouch ? touchTolerance : mouseTolerance,
    viewHeight: height,
    ...(overrides && { overrides }),
    alt: event.altKey,
    shift: event.shiftKey,
    control: event.ctrlKey || event.metaKey,
  };
}

/** The midpoint of all pointers and their mean distance from it, in CSS pixels. */
function gather(
  places: ReadonlyMap<number, ToolPlace>,
): [{ readonly x: number; readonly y: number }, number] {
  const all = [...places.values()];
  const mean = (values: number[]): number => values.reduce((a, b) => a + b, 0) / values.length;
  const middle = {
    x: mean(all.map(({ pixelX }) => pixelX)),
    y: mean(all.map(({ pixelY }) => pixelY)),
  };
  const spread = mean(all.map((at) => Math.hypot(at.pixelX - middle.x, at.pixelY - middle.y)));
  return [middle, spread];
}
