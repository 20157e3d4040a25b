import type { Gpu } from '../gl/gpu.ts';
import { Program } from '../gl/program.ts';
import { type Defines, resolveShader } from '../gl/shader-library.ts';
import type { SkinningMethod } from '../skinning/method.ts';
import { shaderFiles } from './shader-files.ts';

/** How the skinning stage is compiled. For either number, 0 means the texture. */
export interface StageVariant {
  readonly method: SkinningMethod;
  /** The number of vec4s per palette entry. */
  readonly stride: number;
  /** The number of attribute pairs of four influences each, or 0. */
  readonly influencePairs: number;
  /** The number of rows in the uniform array, or 0. */
  readonly paletteRows: number;
}

/** The programs of a context, which are linked at first use and kept. */
export class Programs {
  private readonly gpu: Gpu;
  private readonly linked = new Map<string, Program>();

  constructor(gpu: Gpu) {
    this.gpu = gpu;
  }

  /** Returns the program of shaders/passes/NAME.vert.glsl and NAME.frag.glsl. */
  pass(name: string, defines: Defines = {}): Program {
    return this.find([name, ...Object.entries(defines).flat()].join(' '), () => ({
      vertex: resolveShader(shaderFiles, `passes/${name}.vert.glsl`, defines),
      fragment: resolveShader(shaderFiles, `passes/${name}.frag.glsl`, defines),
    }));
  }

  skinStage({ method, stride, influencePairs, paletteRows }: StageVariant): Program {
    return this.find(`skin ${method.chunk} ${stride} ${influencePairs} ${paletteRows}`, () => {
      const defines = {
        INFLUENCE_PAIRS: influencePairs,
        PALETTE_ROWS: paletteRows,
        PALETTE_STRIDE: stride,
      };
      const names = { METHOD: method.chunk };
      return {
        vertex: resolveShader(shaderFiles, 'skinning/stage.vert.glsl', defines, names),
        fragment: resolveShader(shaderFiles, 'skinning/stage.frag.glsl'),
        feedback: ['posedPosition', 'posedNormal'],
      };
    });
  }

  dispose(): void {
    for (const program of this.linked.values()) program.dispose();
    this.linked.clear();
  }

  private find(
    name: string,
    sources: () => { vertex: string; fragment: string; feedback?: readonly string[] },
  ): Program {
    let program = this.linked.get(name);
    if (!program) {
      program = new Program(this.gpu, { name, ...sources() });
      this.linked.set(name, program);
    }
    return program;
  }
}
