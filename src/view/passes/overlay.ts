import type { Evaluation } from '../../evaluation/evaluation.ts';
import { Buffer } from '../../gl/buffer.ts';
import type { Gpu } from '../../gl/gpu.ts';
import type { Program } from '../../gl/program.ts';
import { type Attribute, VertexArray } from '../../gl/vertex-array.ts';
import type { Frame } from '../frame.ts';
import { chainOf, chainShapes } from '../chain-shapes.ts';
import { type Gizmo, gizmoOf, gizmoRings } from '../gizmo.ts';
import { showsSketch, sketchShapes } from '../ik-sketch-shapes.ts';
import { cutShapes, showsCut } from '../cut-shapes.ts';
import { hasTargets, ikTargets, targetShapes } from '../ik-targets.ts';
import { lightLines, showsLights } from '../light-handles.ts';
import { moveGizmoOf, moveHandles } from '../move-gizmo.ts';
import { natureArcs, natureLookOf } from '../nature-arcs.ts';
import { natureShapes } from '../nature-shapes.ts';
import {
  isFace,
  type Overlay,
  type OverlayFace,
  type OverlayLine,
  type OverlayView,
} from '../overlay.ts';
import type { Pass } from '../pass.ts';
import { pinHandles, pinShapes, showsPins } from '../pin-handles.ts';
import { placeGizmoOf, placeHandles, placeShapes } from '../place-gizmo.ts';
import { gizmoLines, gizmoSectors } from '../ring-lines.ts';
import { pathShapes, showsPaths } from '../rotation-paths.ts';

/** The floats of a piece: three corners, its color with opacity, and its two widths. */
const pieceSize = 15;
/** The widths of a triangle. */
const triangle = [-1, -1] as const;
/** The opacity of what the scene hides, as a part of its own. */
const hiddenOpacity = 0.55;

/**
 * Draws the overlay: lines of constant width and filled faces over the scene, fainter where it
 * hides them.
 */
export const overlayPass: Pass = {
  id: 'overlay',
  isShown: (options) =>
    gizmoOf(options) !== null ||
    placeGizmoOf(options) !== null ||
    chainOf(options) !== null ||
    natureLookOf(options) !== null ||
    showsLights(options) ||
    showsPins(options) ||
    hasTargets(options) ||
    showsSketch(options) ||
    showsPaths(options) ||
    showsCut(options),
  create: overlayDrawer(overlayOf),
};

/**
 * Returns what creates a pass that draws shapes over the scene.
 *
 * @param shapesOf returns the shapes of a frame, with the picture's pixels per CSS pixel
 */
export function overlayDrawer(
  shapesOf: (frame: Frame, cssScale: number) => Overlay,
): Pass['create'] {
  return (gpu, programs) => {
    const { gl } = gpu;
    const program = programs.pass('overlay');
    // The overlay is drawn on the page alone, so that the picture fills the canvas.
    const canvas = gl.canvas as HTMLCanvasElement;
    const pieces = new Pieces(gpu, program);
    return {
      draw(frame) {
        const cssScale = frame.viewport.height / canvas.clientHeight;
        pieces.write(shapesOf(frame, cssScale));
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
  };
}

/** The view of a frame in CSS pixels. */
export function overlayViewOf({ camera, viewport }: Frame, cssScale: number): OverlayView {
  return { camera, width: viewport.width / cssScale, height: viewport.height / cssScale };
}

/** @param cssScale the picture's pixels per CSS pixel */
function overlayOf(frame: Frame, cssScale: number): Overlay {
  const { characters, options } = frame;
  const character = characters.find(({ state }) => state.id === options.selectedActorId);
  const view = overlayViewOf(frame, cssScale);
  const lights = showsLights(options)
    ? lightLines(options.environment, view, options.hoveredHandle)
    : [];
  const sketched = characters.find(({ state }) => state.id === options.ikSketch?.actorId);
  const sketch =
    sketched && showsSketch(options)
      ? sketchShapes(options.ikSketch!, sketched.evaluation.display, view)
      : [];
  const traced = characters.find(({ state }) => state.id === options.rotationPaths?.actorId);
  const paths =
    traced && showsPaths(options)
      ? pathShapes(options.rotationPaths!, traced.evaluation.display, view)
      : [];
  const cut = characters.find(({ state }) => state.id === options.cutSketch?.actorId);
  const figure =
    cut && showsCut(options) ? cutShapes(options.cutSketch!, cut.evaluation.display) : [];
  const handles = showsPins(options)
    ? characters.flatMap(({ evaluation }) => pinHandles(evaluation))
    : [];
  const pins = pinShapes(handles, view, options.hoveredHandle);
  if (!character) return [...lights, ...pins, ...sketch, ...paths, ...figure];
  const { evaluation } = character;
  const [joint, place] = [gizmoOf(options), placeGizmoOf(options)];
  const move = moveGizmoOf(options);
  const [chain, nature] = [chainOf(options), natureLookOf(options)];
  return [
    ...lights,
    ...pins,
    ...sketch,
    ...paths,
    ...figure,
    ...(chain?.actorId === character.state.id ? chainShapes(evaluation, view, chain) : []),
    ...(nature ? natureShapes(natureArcs(evaluation, view, nature)) : []),
    ...(move ? placeShapes(moveHandles(evaluation, view, move), move) : []),
    ...(joint && !move?.isTarget ? ringShapes(evaluation, view, joint) : []),
    ...(hasTargets(options)
      ? targetShapes(ikTargets(evaluation), view, options.hoveredHandle)
      : []),
    ...(place ? placeShapes(placeHandles(evaluation.state, view, place), place) : []),
  ];
}

function ringShapes(evaluation: Evaluation, view: OverlayView, joint: Gizmo): Overlay {
  const rings = gizmoRings(evaluation, view, joint);
  return [...gizmoSectors(rings, joint), ...gizmoLines(rings, joint)];
}

/** The pieces of a shape, as floats. */
function floatsOf(shape: OverlayLine | OverlayFace): number[] {
  const { points, color, opacity } = shape;
  const paint = [...color, opacity];
  if (isFace(shape)) {
    const [first, ...others] = points;
    return others
      .slice(1)
      .flatMap((to, i) => [...first!, ...others[i]!, ...to, ...paint, ...triangle]);
  }
  const widths = [shape.width, shape.endWidth ?? shape.width];
  return points.slice(1).flatMap((to, i) => [...points[i]!, ...to, ...to, ...paint, ...widths]);
}

/** Straight pieces of lines and triangles, which one call draws. */
class Pieces {
  private readonly gpu: Gpu;
  private readonly program: Program;
  private held: { readonly buffer: Buffer; readonly array: VertexArray } | null = null;
  private count = 0;

  constructor(gpu: Gpu, program: Program) {
    this.gpu = gpu;
    this.program = program;
  }

  write(overlay: Overlay): void {
    const floats = overlay.flatMap(floatsOf);
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
    const attribute = (size: 2 | 3 | 4, firstFloat: number): Attribute => ({
      buffer,
      size,
      stride: pieceSize * Float32Array.BYTES_PER_ELEMENT,
      offset: firstFloat * Float32Array.BYTES_PER_ELEMENT,
      perInstance: true,
    });
    return new VertexArray(this.gpu, this.program, {
      startPlace: attribute(3, 0),
      endPlace: attribute(3, 3),
      cornerPlace: attribute(3, 6),
      pieceColor: attribute(4, 9),
      pieceWidths: attribute(2, 13),
    });
  }
}
