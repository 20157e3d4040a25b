import type { Overrides } from '../evaluation/evaluations.ts';
import type { Camera } from '../document/camera.ts';

/** A rectangle of a picture, in whole pixels from its lower left corner. */
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
  /** What differs from the scene in this view. */
  readonly overrides: Overrides;
}

/** The content of a view, before it has a place in a picture. */
export type ViewContent = Omit<RenderView, 'viewport'>;

/**
 * Places views side by side from the left, each at full height. The last one gets the pixels that
 * are left over.
 */
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
