import type { Camera } from '../document/camera.ts';
import { cameraBetween } from '../view/camera-path.ts';
import type { Looking } from './editor.ts';

const easeMilliseconds = 260;

/**
 * Moves the camera in a moment, unless the user asks for less motion or moves it elsewhere.
 *
 * @param from where it is
 * @returns whether nothing else has moved it since
 */
export function moveCamera({ camera }: Looking['viewer'], from: Camera, to: Camera): () => boolean {
  const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const begin = performance.now();
  let shown = from;
  step(isStill ? Infinity : begin);
  return () => camera.peek() === shown;

  function step(now: number): void {
    if (camera.peek() !== shown) return;
    const part = Math.min(1, Math.max(0, (now - begin) / easeMilliseconds));
    shown = cameraBetween(from, to, part * part * (3 - 2 * part));
    camera.value = shown;
    if (part < 1) requestAnimationFrame(step);
  }
}
