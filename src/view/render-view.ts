import type { ReadonlyMat4 } from 'gl-matrix';
import type { Overrides } from '../evaluation/evaluations.ts';
import type { Camera } from '../document/camera.ts';
import type { ViewOptions } from './view-options.ts';

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
  /** The part of the viewport that is in the picture; all of it, if absent. */
  readonly clip?: Viewport;
  /** What differs from the scene in this view. */
  readonly overrides: Overrides;
  /** How it is viewed, where that differs from the other views. */
  readonly options?: Partial<ViewOptions>;
  /** The larger picture that this is a tile of, if it is one. */
  readonly window?: PictureWindow;
  /** How wide lines are, as a factor of their width on the page. */
  readonly lineScale?: number;
}

/** A whole picture in pixels, and the lower left corner of a tile in it. */
export interface PictureWindow {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** From the picture's clip space to that of the tile, which it fills. */
  readonly tileFromPicture: ReadonlyMat4;
}

/** The content of a view, before it has a place in a picture. */
export interface ViewContent extends Pick<RenderView, 'camera' | 'overrides' | 'options'> {
  /**
   * Of a view that has the place of the whole picture, the part that is seen: from where to where,
   * in parts of the width.
   */
  readonly span?: readonly [number, number];
}

/**
 * Places views side by side from the left, each at full height. The last one gets the pixels that
 * are left over. Views of which a part is seen all have the whole place.
 */
export function sideBySide(
  contents: readonly ViewContent[],
  width: number,
  height: number,
): RenderView[] {
  const each = Math.floor(width / contents.length);
  return contents.map((content, index) => {
    if (content.span) {
      const viewport = { x: 0, y: 0, width, height };
      // Parts begin at even pixels, as tiles do.
      const [x, end] = content.span.map((part) =>
        Math.min(width, 2 * Math.round((part * width) / 2)),
      );
      return { ...content, viewport, clip: { ...viewport, x: x!, width: end! - x! } };
    }
    const x = index * each;
    const isLast = index === contents.length - 1;
    return { ...content, viewport: { x, y: 0, width: isLast ? width - x : each, height } };
  });
}
