import { countCalls, type CallCounts } from './count-calls.ts';
import { pictureHeight, pictureWidth } from './picture.ts';

/** The ways in which a frame may follow the one before it. */
export type FrameKind = 'posed' | 'camera' | 'still';

/** A program that draws the body of bench/data, alone on its page. */
export interface FrameContender {
  readonly gl: WebGL2RenderingContext;
  /** Draws pose `index` with the shadows that it throws. */
  posed(index: number): void;
  /** Draws the same pose from another direction. */
  camera(index: number): void;
  /** Draws the same picture again. */
  still(): void;
  /**
   * Whether the body covers each pixel, the bottom row first, without anything else of the picture.
   */
  silhouette(): Uint8Array;
}

export interface FrameOptions {
  /** Of each actor. */
  readonly vertexCount: number;
  readonly jointCount: number;
  readonly actorCount: number;
  readonly shadowSize: number;
  /** Whether the body hangs on a single joint. */
  readonly unskinned: boolean;
}

export interface FrameSample {
  /** Milliseconds of a frame until one of its pixels was read. */
  readonly wall: number;
  /** Milliseconds of a frame until the page's script had issued its calls. */
  readonly script: number;
}

export interface FramePage {
  readonly renderer: string;
  sample(kind: FrameKind, first: number, count: number): FrameSample;
  /** The silhouette of a pose, a letter for each pixel: 1 is covered. */
  silhouette(pose: number): string;
  /** The number of different colors of the last picture, and the first error of WebGL. */
  look(): { readonly colors: number; readonly error: number };
  /** What one frame asks of WebGL. The page's address must contain "count". */
  count(kind: FrameKind, index: number): CallCounts;
}

declare global {
  interface Window {
    frameBench: FramePage;
  }
}

/** Offers a contender to the bench as `window.frameBench`. */
export function offerFrames(create: (options: FrameOptions) => FrameContender): void {
  const parameters = new URLSearchParams(location.search);
  const counts = parameters.has('count') ? countCalls() : null;
  const contender = create({
    vertexCount: Number(parameters.get('vertices')),
    jointCount: Number(parameters.get('joints') ?? 18),
    actorCount: Number(parameters.get('actors') ?? 1),
    shadowSize: Number(parameters.get('shadow')),
    unskinned: parameters.has('unskinned'),
  });
  const { gl } = contender;
  const pixel = new Uint8Array(4);
  const readPixel = (): void => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  window.frameBench = {
    renderer: rendererOf(gl),
    sample(kind, first, count) {
      let script = 0;
      const begin = performance.now();
      for (let i = 0; i < count; i++) {
        const issued = performance.now();
        contender[kind](first + i);
        script += performance.now() - issued;
        readPixel();
      }
      return { wall: (performance.now() - begin) / count, script: script / count };
    },
    silhouette(pose) {
      contender.posed(pose);
      return contender.silhouette().join('');
    },
    look() {
      const pixels = new Uint32Array(pictureWidth * pictureHeight);
      contender.still();
      const bytes = new Uint8Array(pixels.buffer);
      gl.readPixels(0, 0, pictureWidth, pictureHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return { colors: new Set(pixels).size, error: gl.getError() };
    },
    count(kind, index) {
      if (!counts) throw new Error('calls are not counted on this page');
      contender[kind](index - 1);
      counts.reset();
      contender[kind](index);
      readPixel();
      return counts.read(gl);
    },
  };
}

/**
 * Makes a canvas that is not part of the page, so that the browser does not copy its pictures to
 * the page at a time of its own.
 */
export function createCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = pictureWidth;
  canvas.height = pictureHeight;
  return canvas;
}

function rendererOf(gl: WebGL2RenderingContext): string {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
}
