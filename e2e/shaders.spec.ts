import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { expect, type Page } from '@playwright/test';
import { resolveShader, type ShaderFiles } from '../src/gl/shader-library.ts';
import { kernels } from '../src/skinning/registry.ts';
import { sharedPage, test } from './support/test.ts';

interface Sources {
  readonly name: string;
  readonly vertex: string;
  readonly fragment: string;
  readonly feedback?: readonly string[];
}

const folder = path.resolve(import.meta.dirname, '../shaders');
const files: ShaderFiles = Object.fromEntries(
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.glsl'))
    .map((name) => [name.replaceAll('\\', '/'), readFileSync(path.join(folder, name), 'utf8')]),
);

// src/view/programs.ts compiles these numbers of pairs; 0 means the texture.
const influencePairs = [1, 2, 3, 4, 0];
const paletteRows = [1024, 4096, 0];

const passNames = new Set(
  Object.keys(files).flatMap((name) => /^passes\/(.+)\.(?:vert|frag)\.glsl$/.exec(name)?.[1] ?? []),
);
/** The looks of mesh.ts and floor.ts in src/view/passes; passes that know none ignore them. */
const looks = [{}, { FACETED: 1 }, { CUT_OUT: 1 }];
const passes = [...passNames].flatMap((pass) =>
  looks.map((defines) => ({
    name: [pass, ...Object.keys(defines)].join(' '),
    vertex: resolveShader(files, `passes/${pass}.vert.glsl`, defines),
    fragment: resolveShader(files, `passes/${pass}.frag.glsl`, defines),
  })),
);

const page = sharedPage(() => Promise.resolve());

test('every pass links', async () => {
  expect(passes.map(({ name }) => name)).toContain('mesh FACETED');
  expect(await problemsOf(page(), passes)).toEqual([]);
});

for (const method of await Promise.all(kernels.map(({ load }) => load()))) {
  if (method.finish) continue; // it is computed on the CPU
  test(`the skin stage links in every variant: ${method.id}`, async () => {
    const stages = method.strides.flatMap((stride) =>
      influencePairs.flatMap((pairs) =>
        paletteRows.map((rows) => stage(method.chunk, stride, pairs, rows)),
      ),
    );
    expect(stages).toHaveLength(15 * method.strides.length);
    expect(await problemsOf(page(), stages)).toEqual([]);
  });
}

for (const pass of ['lit-limb', 'weights']) {
  test(`${pass}, which reads weights, links in every layout of influences`, async () => {
    const lights = influencePairs.map((pairs) => {
      const defines = { INFLUENCE_PAIRS: pairs };
      return {
        name: `${pairs} pairs`,
        vertex: resolveShader(files, `passes/${pass}.vert.glsl`, defines),
        fragment: resolveShader(files, `passes/${pass}.frag.glsl`, defines),
      };
    });
    expect(await problemsOf(page(), lights)).toEqual([]);
  });
}

test('shaders that do not compile or link are reported', async () => {
  const [sound] = passes;
  const [problem, ...others] = await problemsOf(page(), [
    {
      ...sound!,
      name: 'no vertex stage',
      vertex: sound!.vertex.replace('void main', 'void other'),
    },
    { ...stage('linear-blend', 3, 1, 0), name: 'no such output', feedback: ['nothing'] },
  ]);
  expect(problem).toContain('no vertex stage');
  expect(others).toEqual([expect.stringContaining('no such output')]);
});

function stage(chunk: string, stride: number, pairs: number, rows: number): Sources {
  const defines = { INFLUENCE_PAIRS: pairs, PALETTE_ROWS: rows, PALETTE_STRIDE: stride };
  return {
    name: `${chunk}, ${pairs} pairs, ${rows} rows`,
    vertex: resolveShader(files, 'skinning/stage.vert.glsl', defines, { METHOD: chunk }),
    fragment: resolveShader(files, 'skinning/stage.frag.glsl'),
    feedback: ['posedPosition', 'posedNormal'],
  };
}

/** Compiles and links the programs in a real WebGL2 context and returns its complaints. */
function problemsOf(page: Page, programs: readonly Sources[]): Promise<string[]> {
  return page.evaluate((programs) => {
    const gl = document.createElement('canvas').getContext('webgl2')!;
    const problems: string[] = [];
    for (const { name, vertex, fragment, feedback } of programs) {
      const program = gl.createProgram();
      const logs: (string | null)[] = [];
      for (const [type, source] of [
        [gl.VERTEX_SHADER, vertex],
        [gl.FRAGMENT_SHADER, fragment],
      ] as const) {
        const shader = gl.createShader(type)!;
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
        logs.push(gl.getShaderInfoLog(shader));
      }
      if (feedback) gl.transformFeedbackVaryings(program, [...feedback], gl.SEPARATE_ATTRIBS);
      gl.linkProgram(program);
      logs.push(gl.getProgramInfoLog(program));
      // Warnings count, because other compilers treat them as errors.
      const log = logs.filter(Boolean).join('\n');
      const linked = gl.getProgramParameter(program, gl.LINK_STATUS) as boolean;
      if (!linked || log !== '') problems.push(`${name}: ${log}`);
    }
    return problems;
  }, programs);
}
