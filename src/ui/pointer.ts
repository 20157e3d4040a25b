import { zoom } from '../view/camera.ts';
import type { PickPlace } from '../view/pick.ts';
import type { Editor } from './editor.ts';
import type { Tool } from './tool.ts';

const zoomPerWheelPixel = 0.0012;
const pixelsPerLine = 24;
const panButton = 1;
/** Less than this is a click, not a drag; CSS pixels. */
const stillDistance = 4;
const mouseTolerance = 6;
const touchTolerance = 20;

interface Place {
  readonly x: number;
  readonly y: number;
}

/**
 * Feeds drags on the canvas to the tool, and the wheel to the camera. One finger drags like the left
 * button; two pan with their middle and zoom with their distance.
 */
export function listenToPointer(canvas: HTMLCanvasElement, tool: Tool, editor: Editor): void {
  const { camera } = editor.viewer;
  const places = new Map<number, Place>();
  let button = 0;
  let pressed: Place | null = null;

  canvas.addEventListener('pointerdown', (event) => {
    if (places.size === 0) button = event.button;
    if (event.pointerType === 'mouse' && places.size > 0) return;
    places.set(event.pointerId, placeOf(event));
    pressed = places.size === 1 && event.button === 0 ? placeOf(event) : null;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    event.preventDefault();
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = places.get(event.pointerId);
    if (!before) {
      tool.hover(toolPlace(event, canvas), editor);
      return;
    }
    if (pressed && distance(pressed, placeOf(event)) > stillDistance) pressed = null;
    const [oldMiddle, oldSpread] = gather(places);
    places.set(event.pointerId, placeOf(event));
    const [middle, spread] = gather(places);
    const [deltaX, deltaY] = [middle.x - oldMiddle.x, middle.y - oldMiddle.y];
    const pinching = places.size > 1;
    const viewHeight = canvas.clientHeight;
    tool.drag({ button: pinching ? panButton : button, deltaX, deltaY, viewHeight }, editor);
    if (pinching && spread > 0) camera.value = zoom(camera.value, oldSpread / spread);
  });
  const release = (event: PointerEvent): void => {
    places.delete(event.pointerId);
  };
  canvas.addEventListener('pointerup', (event) => {
    release(event);
    if (pressed) tool.click(toolPlace(event, canvas), editor);
    pressed = null;
  });
  canvas.addEventListener('pointerleave', () => tool.hover(null, editor));
  canvas.addEventListener('pointercancel', release);
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
}

function placeOf({ clientX: x, clientY: y }: PointerEvent): Place {
  return { x, y };
}

function distance(a: Place, b: Place): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function toolPlace(event: PointerEvent, canvas: HTMLCanvasElement): PickPlace {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return {
    x: ((event.clientX - left) / width) * 2 - 1,
    y: 1 - ((event.clientY - top) / height) * 2,
    tolerance: event.pointerType === 'mouse' ? mouseTolerance : touchTolerance,
    viewHeight: height,
  };
}

/** The middle of all pointers, and their mean distance from it. */
function gather(places: ReadonlyMap<number, Place>): [Place, number] {
  const all = [...places.values()];
  const sum = all.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }), { x: 0, y: 0 });
  const middle = { x: sum.x / all.length, y: sum.y / all.length };
  const spread = all.reduce((total, { x, y }) => total + Math.hypot(x - middle.x, y - middle.y), 0);
  return [middle, spread / all.length];
}
