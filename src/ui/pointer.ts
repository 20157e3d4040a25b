import { zoom } from '../view/camera.ts';
import type { Editor } from './editor.ts';
import type { Tool } from './tool.ts';

const zoomPerWheelPixel = 0.0012;
const pixelsPerLine = 24;

/** Feeds drags on the canvas to the tool, and the wheel to the camera. */
export function listenToPointer(canvas: HTMLCanvasElement, tool: Tool, editor: Editor): void {
  let button: number | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    if (button !== null) return;
    button = event.button;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    event.preventDefault();
  });
  canvas.addEventListener('pointermove', (event) => {
    if (button === null) return;
    const { movementX: deltaX, movementY: deltaY } = event;
    tool.drag({ button, deltaX, deltaY, viewHeight: canvas.clientHeight }, editor);
  });
  const release = (): void => {
    button = null;
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => onWheel(event, editor), { passive: false });
}

function onWheel(event: WheelEvent, { viewer: { camera } }: Editor): void {
  event.preventDefault();
  const pixels = event.deltaMode === 0 ? event.deltaY : event.deltaY * pixelsPerLine;
  camera.value = zoom(camera.value, Math.exp(pixels * zoomPerWheelPixel));
}
