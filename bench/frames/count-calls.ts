import { pictureHeight, pictureWidth } from './picture.ts';

/** What a frame asked of WebGL. */
export interface CallCounts {
  /** Draw calls into the picture. */
  readonly pictureDraws: number;
  /** Draw calls into anything else: shadow maps, blurs. */
  readonly otherDraws: number;
  /** Runs of transform feedback. */
  readonly feedbacks: number;
  /** Bytes sent to buffers and textures. */
  readonly uploadedBytes: number;
  /** The side of the largest square depth texture of the page, which is its shadow map. */
  readonly shadowSize: number;
  /** The samples of a pixel of the picture. */
  readonly samples: number;
}

type Call = (this: WebGL2RenderingContext, ...parameters: unknown[]) => unknown;

/** Wraps the functions of every WebGL2 context of the page from now on. */
export function countCalls(): { reset(): void; read(gl: WebGL2RenderingContext): CallCounts } {
  const frame = { pictureDraws: 0, otherDraws: 0, feedbacks: 0, uploadedBytes: 0 };
  let shadowSize = 0;
  let samples = 0;
  let intoPicture = true;

  const draw = (): void => {
    if (intoPicture) frame.pictureDraws++;
    else frame.otherDraws++;
  };
  const upload = (parameters: readonly unknown[]): void => {
    const content = parameters.findLast((each) => ArrayBuffer.isView(each));
    if (content) frame.uploadedBytes += content.byteLength;
  };
  const depth = (format: unknown, width: unknown, height: unknown): void => {
    if (depthFormats.includes(Number(format)) && width === height) {
      shadowSize = Math.max(shadowSize, Number(width));
    }
  };
  const before: Record<string, (parameters: readonly unknown[]) => void> = {
    viewport: ([, , width, height]) => {
      intoPicture = width === pictureWidth && height === pictureHeight;
    },
    drawArrays: draw,
    drawElements: draw,
    drawArraysInstanced: draw,
    drawElementsInstanced: draw,
    beginTransformFeedback: () => frame.feedbacks++,
    bufferData: upload,
    bufferSubData: upload,
    texSubImage2D: upload,
    texImage2D: (parameters) => {
      upload(parameters);
      depth(parameters[2], parameters[3], parameters[4]);
    },
    texStorage2D: ([, , format, width, height]) => depth(format, width, height),
    renderbufferStorageMultisample: ([, count]) => (samples = Math.max(samples, Number(count))),
  };
  const prototype = WebGL2RenderingContext.prototype as unknown as Record<string, Call>;
  for (const [name, note] of Object.entries(before)) {
    const own = prototype[name]!;
    prototype[name] = function (...parameters) {
      note(parameters);
      return own.apply(this, parameters);
    };
  }
  return {
    reset: () =>
      Object.assign(frame, { pictureDraws: 0, otherDraws: 0, feedbacks: 0, uploadedBytes: 0 }),
    read(gl) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      const ofCanvas = Number(gl.getParameter(gl.SAMPLES));
      return { ...frame, shadowSize, samples: Math.max(samples, ofCanvas) };
    },
  };
}

/** DEPTH_COMPONENT16, 24, 32F, DEPTH24_STENCIL8 and DEPTH32F_STENCIL8 */
const depthFormats = [0x81a5, 0x81a6, 0x8cac, 0x88f0, 0x8cad];
