import { Failure } from '../../core/failure.ts';
import type { Overrides } from '../../evaluation/evaluations.ts';
import { RenderTarget } from '../../gl/render-target.ts';
import type { Frame } from '../frame.ts';
import {
  type PictureWindow,
  type RenderView,
  sideBySide,
  type ViewContent,
} from '../render-view.ts';
import type { Renderer } from '../renderer.ts';
import type { ViewOptions } from '../view-options.ts';
import type { CaptureSize, Viewer } from '../viewer.ts';
import { averageSamples } from './average-samples.ts';
import type { Picture } from './encode-picture.ts';
import { drawApart, type HeldMoment, holdMoment } from './held-moment.ts';
import { checkPictureSize, type Tile, tilesOf } from './picture-tiles.ts';

/** What a picture shows, and how finely. */
export interface PictureRequest {
  readonly size: CaptureSize;
  /** Side by side, from the left. */
  readonly contents: readonly ViewContent[];
  /** Whether floor and backdrop are drawn. */
  readonly showSurroundings: boolean;
  /** Samples on each side of a pixel, from 1 to 4. */
  readonly samples: number;
  /** The most samples on a side of a tile; chosen by the size if absent. */
  readonly tileLimit?: number;
  /** Gives what is shown; the page at the moment of the call, if absent. */
  readonly hold?: (overrides?: Overrides) => HeldMoment;
  /** How the scene is viewed, where that differs from the page. */
  readonly options?: Partial<ViewOptions>;
}

/** The work on a picture, as its caller follows it. */
export interface PictureWork {
  readonly signal?: AbortSignal;
  /** @param fraction of the work that is done */
  readonly onProgress?: (fraction: number) => void;
}

/** A tile of one of the views that are side by side. */
export interface TileOfView {
  readonly content: RenderView;
  readonly held: HeldMoment;
  /** The view's place in the picture. */
  readonly view: Tile;
  readonly tile: Tile;
}

/** Lines get wider than on the page in pictures that are taller than this, in pixels. */
const plainHeight = 1080;

/**
 * Draws a picture of the present moment, or of another one that is held, in tiles where it is large.
 * Between tiles the page goes on, whatever changes there.
 *
 * @throws Failure if it can't be made, or if the signal aborts it
 */
export async function makePicture(
  viewer: Viewer,
  { size, contents, showSurroundings, samples, tileLimit, hold, options }: PictureRequest,
  work: PictureWork = {},
): Promise<Picture> {
  checkPictureSize(size);
  const { width, height } = size;
  const picture = { width, height, pixels: new Uint8ClampedArray(width * height * 4) };
  const changed = { ...options, showSurroundings };
  const lineScale = samples * Math.max(1, height / plainHeight);
  await eachTile(viewer, { size, contents, samples, tileLimit, hold }, work, (part) => {
    const { content, held, view, tile } = part;
    const { camera, overrides, options: own } = content;
    const drawn = {
      ...{ camera, overrides, ...(own && { options: own }) },
      viewport: { x: 0, y: 0, width: tile.width * samples, height: tile.height * samples },
      window: windowOf(view, tile, samples),
      lineScale,
    };
    const pixels = drawApart(viewer, drawn, held.shown, changed, captureFrame);
    const drawnPixels = { ...drawn.viewport, pixels };
    averageSamples(drawnPixels, samples, picture, view.x + tile.x, tile.y, content.clip ?? view);
  });
  return picture;
}

/**
 * Visits the tiles of a picture, which all show the moment of the call. After each but the last, the
 * page gets a turn.
 */
export async function eachTile(
  viewer: Viewer,
  {
    size: { width, height },
    contents,
    samples,
    tileLimit,
    hold = (overrides) => holdMoment(viewer, overrides),
  }: Pick<PictureRequest, 'size' | 'contents' | 'samples'> & {
    readonly tileLimit: number | undefined;
    readonly hold?: PictureRequest['hold'] | undefined;
  },
  { signal, onProgress }: PictureWork,
  visit: (part: TileOfView) => void,
): Promise<void> {
  const moments: HeldMoment[] = [];
  try {
    const parts = sideBySide(contents, width, height).flatMap((content): TileOfView[] => {
      const held = hold(content.overrides);
      moments.push(held);
      const { viewport: view, clip = view } = content;
      return tilesOf(view, samples, tileLimit)
        .filter(({ x, width }) => view.x + x < clip.x + clip.width && view.x + x + width > clip.x)
        .map((tile) => ({ content, held, view, tile }));
    });
    for (const [at, part] of parts.entries()) {
      if (at > 0) await new Promise((resolve) => setTimeout(resolve));
      if (signal?.aborted) throw new Failure('Canceled');
      if (!viewer.available.value) {
        throw new Failure('The graphics context was lost, so the picture was not finished');
      }
      visit(part);
      onProgress?.((at + 1) / parts.length);
    }
  } finally {
    for (const held of moments) held.release();
  }
}

/** A tile as a window of its view's picture, in samples. */
export function windowOf(view: CaptureSize, tile: Tile, samples: number): PictureWindow {
  const [across, up] = [view.width / tile.width, view.height / tile.height];
  const right = across - (2 * tile.x) / tile.width - 1;
  const above = up - (2 * tile.y) / tile.height - 1;
  const tileFromPicture = Float64Array.of(
    ...[across, 0, 0, 0],
    ...[0, up, 0, 0],
    ...[0, 0, 1, 0],
    ...[right, above, 0, 1],
  );
  const [x, y] = [tile.x * samples, tile.y * samples];
  const [width, height] = [view.width * samples, view.height * samples];
  return { x, y, width, height, tileFromPicture };
}

/** Returns (width × height × 4) bytes of RGBA, the bottom row first. */
export function captureFrame(renderer: Renderer, frame: Frame): Uint8Array {
  const { width, height } = frame.viewport;
  const target = new RenderTarget(renderer.gpu, width, height);
  try {
    renderer.drawInto(target, [frame]);
    return target.readPixels();
  } finally {
    target.dispose();
  }
}
