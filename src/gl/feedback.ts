import type { Buffer } from './buffer.ts';
import type { Gpu } from './gpu.ts';

/** Runs a vertex stage only for its outputs, with one buffer per output; nothing is rasterized. */
export class Feedback {
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLTransformFeedback;
  private readonly untrack: () => void;

  constructor(gpu: Gpu, outputs: readonly Buffer[]) {
    const { gl } = gpu;
    this.gl = gl;
    this.handle = gl.createTransformFeedback();
    this.untrack = gpu.track('transform-feedback');
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, this.handle);
    outputs.forEach(({ handle }, index) => {
      gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, index, handle);
    });
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
  }

  /** The program must be in use and its vertex array bound. */
  run(vertexCount: number): void {
    const { gl } = this;
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, this.handle);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, vertexCount);
    gl.endTransformFeedback();
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.disable(gl.RASTERIZER_DISCARD);
  }

  dispose(): void {
    this.gl.deleteTransformFeedback(this.handle);
    this.untrack();
  }
}
