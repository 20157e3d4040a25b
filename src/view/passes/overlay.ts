import { Buffer } from '../../gl/buffer.ts';
import type { Gpu } from '../../gl/gpu.ts';
import type { Program } from '../../gl/program.ts';
import { type Attribute, VertexArray } from '../../gl/vertex-array.ts';
import type { Frame } from '../frame.ts';
import { gizmoLines, gizmoOf, gizmoRings } from '../gizmo.ts';
import type { Overlay } from '../overlay.ts';
import type { Pass } from '../pass.ts';

/** The floats of a piece of a line: its two ends, its color with opacity, and its width. */
const pieceSize = 11;
/** The opacity of what the scene hides, as a part of its own. */
const hiddenOpacity = 0.55;

/** Draws the overlay: lines of constant width over the scene, fainter where it hides them. */
export const overlayPass: Pass = {
  id: 'overlay',
  isShown: (options) => gizmoOf(options) !== null,
  create(gpu, programs) {
    const { gl } = gpu;
    const program = programs.pass('overlay');
    // The overlay is drawn on the page alone, so that the picture fills the canvas.
    const canvas = gl.canvas as HTMLCanvasElement;
    const pieces = new LinePieces(gpu, program);
    return {
      draw(frame) {
        const cssScale = frame.viewport.height / canvas.clientHeight;
        pieces.write(overlayOf(frame, cssScale));
        program.use();
        program.set(frame.uniforms);
        program.set({ cssScale });
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gl.depthFunc(gl.GREATER);
        program.set({ opacity: hiddenOpacity });
        pieces.draw();
        gl.depthFunc(gl.LEQUAL);
        program.set({ opacity: 1 });
        pieces.draw();
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => pieces.dispose(),
    };
  },
};

/** @param cssScale the picture's pixels per CSS pixel */
function overlayOf({ characters, options, camera, viewport }: Frame, cssScale: number): Overlay {
  const gizmo = gizmoOf(options);
  const character = characters.find(({ state }) => state.id === options.selectedActorId);
  if (!gizmo || !character) return [];
  const view = { camera, width: viewport.width / cssScale, height: viewport.height / cssScale };
  return gizmoLines(gizmoRings(character.evaluation, view, gizmo), gizmo);
}

/** The straight pieces of lines, which one call draws. */
class LinePieces {
  private readonly gpu: Gpu;
  private readonly program: Program;
  private held: { readonly buffer: Buffer; readonly array: VertexArray } | null = null;
  private count = 0;

  constructor(gpu: Gpu, program: Program) {
    this.gpu = gpu;
    this.program = program;
  }

  write(overlay: Overlay): void {
    const floats = overlay.flatMap(({ points, color, opacity, width }) =>
      points.slice(1).flatMap((to, i) => [...points[i]!, ...to, ...color, opacity, width]),
    );
    this.count = floats.length / pieceSize;
    if (this.count === 0) return;
    const bytes = Float32Array.from(floats);
    if (!this.held || this.held.buffer.byteLength < bytes.byteLength) {
      this.dispose();
      const buffer = new Buffer(this.gpu, 'vertex', bytes.byteLength);
      this.held = { buffer, array: this.createArray(buffer) };
    }
    this.held.buffer.write(bytes);
  }

  draw(): void {
    if (!this.held || this.count === 0) return;
    const { gl } = this.gpu;
    this.held.array.bind();
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.count);
  }

  dispose(): void {
    this.held?.array.dispose();
    this.held?.buffer.dispose();
    this.held = null;
  }

  private createArray(buffer: Buffer): VertexArray {
    const attribute = (size: 1 | 3 | 4, firstFloat: number): Attribute => ({
      buffer,
      size,
      stride: pieceSize * Float32Array.BYTES_PER_ELEMENT,
      offset: firstFloat * Float32Array.BYTES_PER_ELEMENT,
      perInstance: true,
    });
    return new VertexArray(this.gpu, this.program, {
      startPlace: attribute(3, 0),
      endPlace: attribute(3, 3),
      pieceColor: attribute(4, 6),
      pieceWidth: attribute(1, 10),
    });
  }
}
