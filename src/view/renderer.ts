import type { Document } from '../document/document.ts';
import type { SkinDevice } from '../document/session.ts';
import { Gpu } from '../gl/gpu.ts';
import { RenderTarget } from '../gl/render-target.ts';
import { CharacterView } from './character-view.ts';
import type { Frame } from './frame.ts';
import { Lighting } from './lighting.ts';
import type { PassInstance } from './pass.ts';
import { passes } from './passes/registry.ts';
import { Programs } from './programs.ts';

/** Everything that lives on one WebGL2 context; after a lost context a new one takes its place. */
export class Renderer {
  readonly gpu: Gpu;
  private readonly programs: Programs;
  private readonly lighting: Lighting;
  private readonly passes: readonly PassInstance[];
  private views: readonly CharacterView[] = [];
  private target: RenderTarget | null = null;

  constructor(gl: WebGL2RenderingContext) {
    this.gpu = new Gpu(gl);
    this.programs = new Programs(this.gpu);
    this.lighting = new Lighting(this.gpu, this.programs);
    this.passes = passes.map((pass) => pass.create(this.gpu, this.programs));
    gl.enable(gl.DEPTH_TEST);
  }

  /** Brings the views in line with the document and their poses up to date. */
  sync(document: Document, device: SkinDevice): readonly CharacterView[] {
    const kept = new Set<CharacterView>();
    const views = document.characters.map((state) => {
      let view = this.views.find((each) => each.fits(state) && !kept.has(each));
      view ??= new CharacterView(this.gpu, this.programs, state);
      view.state = state;
      kept.add(view);
      return view;
    });
    for (const view of this.views) if (!kept.has(view)) view.dispose();
    this.views = views;
    for (const view of views) view.update(device);
    return views;
  }

  /** Draws the frame into a picture of the given size, ready to be shown or read. */
  draw(frame: Frame, width: number, height: number): RenderTarget {
    const target = this.targetOf(width, height);
    const { gl } = this.gpu;
    const lights = this.lighting.prepare(frame);
    const litFrame = { ...frame, uniforms: { ...frame.uniforms, ...lights } };
    target.begin();
    gl.clear(gl.DEPTH_BUFFER_BIT);
    for (const pass of this.passes) pass.draw(litFrame);
    gl.bindVertexArray(null);
    target.resolve();
    return target;
  }

  dispose(): void {
    for (const view of this.views) view.dispose();
    for (const pass of this.passes) pass.dispose();
    this.lighting.dispose();
    this.programs.dispose();
    this.target?.dispose();
  }

  private targetOf(width: number, height: number): RenderTarget {
    if (this.target?.width !== width || this.target.height !== height) {
      this.target?.dispose();
      this.target = new RenderTarget(this.gpu, width, height);
    }
    return this.target;
  }
}
