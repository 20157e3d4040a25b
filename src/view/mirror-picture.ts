import type { Gpu } from '../gl/gpu.ts';
import { RenderTarget } from '../gl/render-target.ts';
import { TextureTarget } from '../gl/texture-target.ts';
import type { Frame } from './frame.ts';

/** A picture as large as the frame's, which shaders read; transparent where nothing is drawn. */
export class MirrorPicture {
  private readonly gpu: Gpu;
  private readonly unit: number;
  private held: {
    readonly key: string;
    readonly target: RenderTarget;
    readonly result: TextureTarget;
  } | null = null;

  /** @param unit the texture unit that it may use */
  constructor(gpu: Gpu, unit: number) {
    this.gpu = gpu;
    this.unit = unit;
  }

  draw({ viewport: { width, height }, detail }: Frame, drawScene: () => void): void {
    const { gl } = this.gpu;
    const key = `${width} ${height} ${detail}`;
    if (this.held?.key !== key) {
      this.dispose();
      // A new texture is bound for a moment; the other units hold the frame's shadows.
      gl.activeTexture(gl.TEXTURE0 + this.unit);
      const target = new RenderTarget(this.gpu, width, height, detail === 'draft' ? 0 : 4);
      this.held = { key, target, result: new TextureTarget(this.gpu, width, height) };
    }
    const { target, result } = this.held;
    target.begin();
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    drawScene();
    target.resolveInto(result);
  }

  bind(): void {
    this.held?.result.texture.bind(this.unit);
  }

  dispose(): void {
    this.held?.target.dispose();
    this.held?.result.dispose();
    this.held = null;
  }
}
