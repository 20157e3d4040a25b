import { zoom } from '../view/camera.ts';
import { selectActor } from '../document/reconcile.ts';
import { boneAt, selectedBoneAt } from '../view/pick.ts';
import type { Looking } from './editor.ts';
import { showHover } from './hover.ts';
import type { ToolDrag, ToolPlace } from './tool.ts';
import { tools } from './tools/registry.ts';

const zoomPerWheelPixel = 0.0012;
const pixelsPerLine = 24;
const panButton = 1;
/** A pointer that moves less has clicked, not dragged; CSS pixels. */
const stillDistance = 4;
const mouseTolerance = 6;
const touchTolerance = 20;

/**
 * Sends drags on the canvas to the first tool that accepts them, and the wheel to the camera.
 * Hovering highlights a joint, and a click selects it. One finger drags like the left button. Two
 * fingers pan with their midpoint and zoom with their distance, whatever the first finger had
 * begun.
 */
export function listenToPointer(canvas: HTMLCanvasElement, editor: Looking): void {
  const { camera } = editor.viewer;
  const { session } = editor;
  const places = new Map<number, ToolPlace>();
  let drag: ToolDrag | null = null;
  let pressed: ToolPlace | null = null;

  canvas.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && places.size > 0) return;
    const place = placeOf(event, canvas, editor.viewer.contents.length);
    places.set(event.pointerId, place);
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    event.preventDefault();
    const isFirst = places.size === 1;
    if (!isFirst) drag?.cancel();
    drag = press(place, isFirst ? event.button : panButton);
    pressed = isFirst && event.button === 0 ? place : null;
  });
  canvas.addEventListener('pointermove', (event) => {
    const place = placeOf(event, canvas, editor.viewer.contents.length);
    if (!places.has(event.pointerId)) {
      hover(place);
      return;
    }
    if (pressed && distance(pressed, place) > stillDistance) pressed = null;
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
    if (pressed) click(placeOf(event, canvas, editor.viewer.contents.length));
    pressed = null;
  });
  canvas.addEventListener('pointercancel', (event) => {
    places.delete(event.pointerId);
    drag?.cancel();
    drag = null;
    pressed = null;
  });
  canvas.addEventListener('pointerleave', () => showHover(editor, null, null));
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * pixelsPerLine;
      camera.value = zoom(camera.value, Math.exp(pixels * zoomPerWheelPixel));
    },
    { passive: false },
  );

  function press(place: ToolPlace, button: number): ToolDrag | null {
    for (const tool of tools) {
      const begun = tool.press(place, button, editor);
      if (begun) return begun;
    }
    return null;
  }

  /**
   * If neither bones nor bone mode are on, nothing is highlighted, because the pointer moves the
   * camera.
   */
  function hover(place: ToolPlace): void {
    const lights = session.showSkeleton.value || session.boneMode.value;
    showHover(
      editor,
      place,
      lights && !session.playing.value ? selectedBoneAt(editor, place) : null,
    );
  }

  function click(place: ToolPlace): void {
    const target = boneAt(editor, place);
    const { selectedJoint, activeDof } = session;
    if (!target) return;
    selectActor(session, editor.store.scene.value, target.actorId);
    if (selectedJoint.value !== target.joint) activeDof.value = null;
    selectedJoint.value = target.joint;
  }
}

function placeOf(event: PointerEvent, canvas: HTMLCanvasElement, viewCount: number): ToolPlace {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const [pixelX, pixelY] = [event.clientX - left, event.clientY - top];
  // Views side by side each have their own left and right edge.
  const each = width / viewCount;
  const within = pixelX - each * Math.min(viewCount - 1, Math.max(0, Math.floor(pixelX / each)));
  return {
    x: (within / each) * 2 - 1,
    y: 1 - (pixelY / height) * 2,
    pixelX,
    pixelY,
    tolerance: event.pointerType === 'mouse' ? mouseTolerance : touchTolerance,
    viewHeight: height,
    alt: event.altKey,
  };
}

function distance(a: ToolPlace, b: ToolPlace): number {
  return Math.hypot(a.pixelX - b.pixelX, a.pixelY - b.pixelY);
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
