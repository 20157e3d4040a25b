import type { Gpu } from '../../gl/gpu.ts';
import type { Program } from '../../gl/program.ts';
import type { SkinningMethod } from '../../skinning/method.ts';
import { maximumPairs } from '../influence-layout.ts';
import { blockSizes } from '../palette-buffer.ts';
import { Programs } from '../programs.ts';
import { shaderFiles } from '../shader-files.ts';

/** One program of Sinew, as this machine compiles and links it. */
export interface LinkedProgram {
  readonly name: string;
  readonly milliseconds: number;
  /** What the compiler or linker says against it, or null. */
  readonly problem: string | null;
}

/**
 * Returns one function for each program of all passes whose shaders are loaded, and of these
 * kernels in every layout of palette and influences. Each links its program when it is called.
 */
export function programLinks(
  gpu: Gpu,
  kernels: readonly SkinningMethod[],
): (() => LinkedProgram)[] {
  const programs = new Programs(gpu);
  const passes = Object.keys(shaderFiles).flatMap(
    (file) => /^passes\/(.+)\.vert\.glsl$/.exec(file)?.[1] ?? [],
  );
  const pairs = Array.from({ length: maximumPairs + 1 }, (_, count) => count);
  const onGpu = kernels.filter((method) => !('finish' in method));
  const variants = onGpu.flatMap((method) => method.strides.map((stride) => ({ method, stride })));
  const stages = variants.flatMap((variant) =>
    pairs.flatMap((influencePairs) =>
      [0, ...blockSizes(gpu)].map((paletteRows) => ({ ...variant, influencePairs, paletteRows })),
    ),
  );
  return [
    ...passes.map((pass) => () => link(pass, () => programs.pass(pass))),
    ...stages.map((stage) => () => {
      const { method, stride, influencePairs, paletteRows } = stage;
      const name = `${method.id} of ${stride} vec4s, ${influencePairs} pairs of influences, ${paletteRows} rows`;
      return link(name, () => programs.skinStage(stage));
    }),
  ];
}

function link(name: string, create: () => Program): LinkedProgram {
  const begin = performance.now();
  let problem: string | null = null;
  try {
    const program = create();
    program.finish();
    program.dispose();
  } catch (error) {
    problem = error instanceof Error ? error.message : String(error);
  }
  return { name, milliseconds: performance.now() - begin, problem };
}
