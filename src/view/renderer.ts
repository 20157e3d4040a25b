import { type Actor, skinInUse } from '../document/scene.ts';
import type { Detail, SkinDevice } from '../document/session.ts';
import type { Skin } from '../core/skin.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { Gpu, GpuLimitError } from '../gl/gpu.ts';
import { RenderTarget } from '../gl/render-target.ts';
import { CharacterView } from './character-view.ts';
import type { Frame } from './frame.ts';
import { GpuPools } from './gpu-pools.ts';
import type { OnImage } from './lazy-dress.ts';
import { Lighting } from './lighting.ts';
import type { Pass, PassInstance } from './pass.ts';
import { firstPrograms } from './passes/first.ts';
import { Programs } from './programs.ts';
import type { LayoutChoice } from './skinned-mesh.ts';

/**
 * Everything that lives on one WebGL2 context. After the context is lost, a new renderer replaces
 * it.
 */
export class Renderer {
  readonly gpu: Gpu;
  /** The passes in the order of drawing; each is created for its first picture. */
  passes: readonly Pass[] = [];
  readonly programs: Programs;
  private readonly pools = new GpuPools();
  /**
   * There is one for each frame of a picture, so that halves with different poses keep their
   * shadows.
   */
  private readonly lightings: Lighting[] = [];
  private readonly instances = new Map<Pass, PassInstance>();
  private readonly layout: LayoutChoice;
  private readonly onImage: OnImage;
  private views: ReadonlyMap<Evaluation, CharacterView> = new Map();
  private readonly targets = new Map<Detail, RenderTarget>();
  /**
   * The reasons why the GPU can't draw characters, by their skins, so that it does not try again
   * for every picture.
   */
  private readonly refusals = new WeakMap<Skin, string>();

  constructor(gl: WebGL2RenderingContext, layout: LayoutChoice, onImage: OnImage) {
    this.onImage = onImage;
    this.gpu = new Gpu(gl);
    this.layout = layout;
    this.programs = new Programs(this.gpu);
    for (const name of firstPrograms) this.programs.pass(name);
    gl.enable(gl.DEPTH_TEST);
  }

  /** Updates the objects on the GPU to match what is to be shown, including the poses. */
  sync(shown: readonly Evaluation[], device: SkinDevice): void {
    const views = new Map<Evaluation, CharacterView>();
    for (const evaluation of shown) {
      const view = this.views.get(evaluation) ?? this.createView(evaluation);
      if (view) views.set(evaluation, view);
    }
    for (const [evaluation, view] of this.views) if (!views.has(evaluation)) view.dispose();
    this.views = views;
    for (const view of views.values()) {
      view.wear();
      view.update(device);
    }
  }

  /** Returns the views of the characters that the GPU can draw, as of the last `sync`. */
  viewsOf(evaluations: readonly Evaluation[]): readonly CharacterView[] {
    return evaluations.flatMap((evaluation) => this.views.get(evaluation) ?? []);
  }

  /** Settles when the pictures of all surfaces are decoded, as of the last `sync`. */
  texturesLoaded(): Promise<unknown> {
    return Promise.all([...this.views.values()].map((view) => view.dressed()));
  }

  /** The reason why the character can't be drawn, or null. */
  refusalOf(state: Actor): string | null {
    return this.refusals.get(skinInUse(state)) ?? null;
  }

  /**
   * Draws frames, each in its own part of a picture, which can then be shown or read. A draft has
   * one sample per pixel.
   */
  draw(
    frames: readonly Frame[],
    width: number,
    height: number,
    detail: Detail = 'full',
  ): RenderTarget {
    let target = this.targets.get(detail);
    if (target?.width !== width || target.height !== height) {
      target?.dispose();
      this.targets.delete(detail);
      target = new RenderTarget(this.gpu, width, height, detail === 'draft' ? 0 : 4);
      this.targets.set(detail, target);
    }
    this.drawInto(target, frames);
    return target;
  }

  dispose(): void {
    for (const view of this.views.values()) view.dispose();
    for (const pass of this.instances.values()) pass.dispose();
    for (const lighting of this.lightings) lighting.dispose();
    this.programs.dispose();
    for (const target of this.targets.values()) target.dispose();
  }

  private createView(evaluation: Evaluation): CharacterView | null {
    const { skin } = evaluation;
    if (this.refusals.has(skin)) return null;
    try {
      return new CharacterView(
        this.gpu,
        this.programs,
        this.pools,
        evaluation,
        this.onImage,
        this.layout,
      );
    } catch (error) {
      if (!(error instanceof GpuLimitError)) throw error;
      this.refusals.set(skin, error.message);
      return null;
    }
  }

  private instanceOf(pass: Pass): PassInstance {
    let instance = this.instances.get(pass);
    if (!instance) this.instances.set(pass, (instance = pass.create(this.gpu, this.programs)));
    return instance;
  }

  /**
   * Each of several frames is drawn separately and then copied to its place. It is thus the same
   * picture as it would be alone, regardless of the rounding that an offset would cause.
   */
  drawInto(target: RenderTarget, frames: readonly Frame[]): void {
    const [only] = frames;
    if (only && frames.length === 1) {
      this.drawFrame(target, only, 0);
      return;
    }
    for (const [index, frame] of frames.entries()) {
      const { width, height } = frame.viewport;
      const part = new RenderTarget(this.gpu, width, height);
      try {
        this.drawFrame(part, frame, index);
        target.paste(part, frame.viewport, frame.clip);
      } finally {
        part.dispose();
      }
    }
  }

  private drawFrame(target: RenderTarget, frame: Frame, index: number): void {
    const { gl } = this.gpu;
    const lighting = (this.lightings[index] ??= new Lighting(this.gpu, this.programs));
    const lights = lighting.prepare(frame);
    const litFrame = { ...frame, uniforms: { ...frame.uniforms, ...lights } };
    const passes = this.passes.filter((pass) => pass.isShown(frame.options));
    const drawMirrored = (mirrored: Frame): void => {
      for (const pass of passes) if (pass.isMirrored) this.instanceOf(pass).draw(mirrored);
    };
    for (const pass of passes) this.instanceOf(pass).prepare?.(litFrame, drawMirrored);
    target.begin();
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const pass of passes) this.instanceOf(pass).draw(litFrame);
    gl.bindVertexArray(null);
    target.resolve();
  }
}
