import type { Overrides } from '../evaluation/evaluations.ts';
import type { Camera } from './camera.ts';

/** A rectangle of a picture; pixels from its lower left corner, whole numbers. */
export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** What one camera sees of the scene, in a part of the picture. */
export interface RenderView {
  readonly camera: Camera;
  readonly viewport: Viewport;
  /** What is other than the scene has it. */
  readonly overrides: Overrides;
}

/** What a view shows, before it has its place in a picture. */
export type ViewContent = Omit<RenderView, 'viewport'>;

/** Views side by side, from the left, all of the height; the last takes the pixels that are left over. */
export function sideBySide(
  contents: readonly ViewContent[],
  width: number,
  height: number,
): RenderView[] {
  const each = Math.floor(width / contents.length);
  return contents.map((content, index) => {
    const x = index * each;
    const isLast = index === contents.length - 1;
    return { ...content, viewport: { x, y: 0, width: isLast ? width - x : each, height } };
  });
}
