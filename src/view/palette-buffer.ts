import { Buffer } from '../gl/buffer.ts';
import { DataTexture } from '../gl/data-texture.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Program } from '../gl/program.ts';

const bytesPerRow = 16;
/** Every WebGL2 device supports blocks of 16 KiB. */
const smallBlockRows = (16 * 1024) / bytesPerRow;
const largeBlockRows = (64 * 1024) / bytesPerRow;

/** The sizes in which this GPU takes a palette as a uniform array, in rows, the smallest first. */
export function blockSizes({ maxUniformBlockSize }: Gpu): readonly number[] {
  return [smallBlockRows, largeBlockRows].filter(
    (rows) => rows * bytesPerRow <= maxUniformBlockSize,
  );
}

const blockBinding = 0;
const textureUnit = 0;

/**
 * The palette on the GPU. It is a uniform array if its rows fit in a block, and otherwise a
 * texture. The buffer is as large as the block that the shader declares; only the rows in use are
 * uploaded.
 */
export class PaletteBuffer {
  /** The number of rows in the uniform array, or 0 for the texture. */
  readonly blockRows: number;
  private readonly gl: WebGL2RenderingContext;
  private readonly block: Buffer | null;
  private readonly texture: DataTexture | null;

  constructor(gpu: Gpu, rowCount: number, forceTexture = false) {
    this.gl = gpu.gl;
    const fitting = blockSizes(gpu).find((rows) => rowCount <= rows) ?? 0;
    this.blockRows = forceTexture ? 0 : fitting;
    this.block =
      this.blockRows > 0 ? new Buffer(gpu, 'uniform', this.blockRows * bytesPerRow) : null;
    this.texture = this.block ? null : new DataTexture(gpu, 'data-rgba32f', rowCount);
  }

  write(palette: Float32Array): void {
    this.block?.write(palette);
    this.texture?.write(palette);
  }

  /** Binds the palette for a program, which must be in use. */
  bind(program: Program): void {
    if (this.block) {
      program.bindBlock('Palette', blockBinding);
      this.gl.bindBufferBase(this.gl.UNIFORM_BUFFER, blockBinding, this.block.handle);
    } else {
      this.texture?.bind(textureUnit);
      program.set({ paletteTexture: textureUnit });
    }
  }

  dispose(): void {
    this.block?.dispose();
    this.texture?.dispose();
  }
}
