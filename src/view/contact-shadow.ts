import type { Gpu } from '../gl/gpu.ts';
import type { Texture } from '../gl/texture.ts';
import { TextureTarget } from '../gl/texture-target.ts';
import type { CharacterView } from './character-view.ts';
import type { Programs } from './programs.ts';
import type { Subject } from './subject.ts';

/** The texels on a side of what is drawn, and of its blurs, which need no more. */
const [drawnSize, blurredSize] = [256, 128];
/**
 * The standard deviations of the two blurs in scene units: where feet touch the floor, and of the
 * body above.
 */
const contactBlur = 0.01;
const broadBlur = 0.07;

/**
 * The characters as the floor sees them from below: red where they nearly touch it, green for the
 * body above. Both are blurred.
 */
export class ContactShadow {
  /**
   * The center's x and z and half the side of the floor's square that the texture covers, in scene
   * space.
   */
  square: readonly [number, number, number] = [0, 0, 1];
  private readonly gl: WebGL2RenderingContext;
  private readonly programs: Programs;
  private readonly drawn: TextureTarget;
  private readonly blurredAcross: TextureTarget;
  private readonly blurred: TextureTarget;

  constructor(gpu: Gpu, programs: Programs) {
    this.gl = gpu.gl;
    this.programs = programs;
    this.drawn = new TextureTarget(gpu, drawnSize, drawnSize);
    this.blurredAcross = new TextureTarget(gpu, blurredSize, blurredSize);
    this.blurred = new TextureTarget(gpu, blurredSize, blurredSize);
  }

  get texture(): Texture {
    return this.blurred.texture;
  }

  draw(casters: readonly CharacterView[], { center, radius }: Subject): void {
    const { gl } = this;
    this.square = [center[0], center[2], radius + 3 * broadBlur];
    gl.disable(gl.DEPTH_TEST);
    this.drawFromBelow(casters);
    this.blur(this.drawn.texture, this.blurredAcross, [1, 0]);
    this.blur(this.blurredAcross.texture, this.blurred, [0, 1]);
    gl.enable(gl.DEPTH_TEST);
  }

  dispose(): void {
    this.drawn.dispose();
    this.blurredAcross.dispose();
    this.blurred.dispose();
  }

  private drawFromBelow(casters: readonly CharacterView[]): void {
    const { gl } = this;
    const program = this.programs.pass('contact-shadow');
    this.drawn.begin();
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.MAX);
    program.use();
    program.set({ contactSquare: this.square });
    for (const caster of casters) caster.drawCaster(program);
    gl.blendEquation(gl.FUNC_ADD);
    gl.disable(gl.BLEND);
  }

  private blur(from: Texture, to: TextureTarget, direction: readonly [number, number]): void {
    const { gl } = this;
    const program = this.programs.pass('blur');
    const scale = 1 / (2 * this.square[2]);
    to.begin();
    program.use();
    from.bind(0);
    program.set({
      source: 0,
      redStep: direction.map((component) => component * contactBlur * scale),
      greenStep: direction.map((component) => component * broadBlur * scale),
    });
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
