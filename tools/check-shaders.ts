/**
 * Checks every shader program with glslangValidator if it is installed. It is stricter than the
 * browsers' own compilers, and needs no browser. The app's own shader library assembles the
 * programs, which are compiled and linked. Prints `skipped: …` if the validator is missing; the
 * browser tests link every program in any case.
 */
import { execFile } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { resolveShader, type Defines } from '../src/gl/shader-library.ts';
import type { SkinningMethod } from '../src/skinning/method.ts';
import { kernels } from '../src/skinning/registry.ts';
import { cacheFolder, findOnPath, root } from './commands.mjs';

// The app compiles these variants (src/view/programs.ts). In either list, 0 means the texture.
const influencePairs = [1, 2, 3, 4, 0];
const paletteRows = [1024, 4096, 0];
/** The looks of mesh.ts and floor.ts in src/view/passes; passes that know none ignore them. */
const looks: readonly Defines[] = [{}, { FACETED: 1 }, { CUT_OUT: 1 }];

interface Program {
  readonly name: string;
  readonly vertex: string;
  readonly fragment: string;
}

interface Outcome {
  readonly status: number;
  readonly output: string;
}

const shaderFolder = path.join(root, 'shaders');
const files = readShaders();

function readShaders(): Record<string, string> {
  const names = readdirSync(shaderFolder, { recursive: true, encoding: 'utf8' })
    .map((name) => name.replaceAll('\\', '/'))
    .filter((name) => name.endsWith('.glsl'))
    .sort();
  return Object.fromEntries(
    names.map((name) => [
      name,
      markLines(name, readFileSync(path.join(shaderFolder, name), 'utf8')),
    ]),
  );
}

/** Marks the end of every line with its place, so that messages can name the file. */
function markLines(name: string, source: string): string {
  return source
    .split(/\r?\n/)
    .map((line, index) => {
      const isLeftAsIs = line.endsWith('\\') || line.trimStart().startsWith('#include');
      return isLeftAsIs ? line : `${line} // @${name}:${index + 1}`;
    })
    .join('\n');
}

function listPrograms(loaded: readonly SkinningMethod[]): (() => Program)[] {
  const passes = Object.keys(files)
    .map((name) => /^passes\/(.+)\.(?:vert|frag)\.glsl$/.exec(name)?.[1])
    .filter((pass) => pass !== undefined);
  const passPrograms = [...new Set(passes)].flatMap((pass) =>
    looks.map((defines) => () => ({
      name: ['pass', pass, ...Object.keys(defines)].join(' '),
      vertex: resolveShader(files, `passes/${pass}.vert.glsl`, defines),
      fragment: resolveShader(files, `passes/${pass}.frag.glsl`, defines),
    })),
  );
  const onGpu = loaded.filter((method) => !('finish' in method));
  const variants = onGpu.flatMap((method) => method.strides.map((stride) => ({ method, stride })));
  const stagePrograms = variants.flatMap(({ method, stride }) =>
    influencePairs.flatMap((pairs) =>
      paletteRows.map((rows) => () => {
        const defines: Defines = {
          INFLUENCE_PAIRS: pairs,
          PALETTE_ROWS: rows,
          PALETTE_STRIDE: stride,
        };
        const names = { METHOD: method.chunk };
        return {
          name: `skin stage ${method.id} ${stride}, INFLUENCE_PAIRS ${pairs}, PALETTE_ROWS ${rows}`,
          vertex: resolveShader(files, 'skinning/stage.vert.glsl', defines, names),
          fragment: resolveShader(files, 'skinning/stage.frag.glsl'),
        };
      }),
    ),
  );
  return [...passPrograms, ...stagePrograms];
}

/** Returns the errors of a program, with the place of each. */
async function check(validator: string, program: Program, folder: string): Promise<string[]> {
  mkdirSync(folder, { recursive: true });
  const sources: Record<string, string> = {
    'stage.vert': program.vertex,
    'stage.frag': program.fragment,
  };
  for (const [name, source] of Object.entries(sources)) {
    writeFileSync(path.join(folder, name), `${source}\n`);
  }
  const { status, output } = await run(validator, ['-l', ...Object.keys(sources)], folder);
  if (status === 0) return [];
  const messages = output
    .split(/\r?\n/)
    .filter((line) => !(line in sources) && !/^$|compilation terminated|No code gen/.test(line));
  return [
    messages
      .map((message) =>
        message.replace(/^ERROR: (stage\.\w+):(\d+): /, (_, stage: string, line: string) =>
          placeOf(sources[stage] ?? '', Number(line)),
        ),
      )
      .join('\n') || `exit code ${status}`,
  ];
}

/**
 * Lines without a mark (the head, and parts of long macros) belong to the next line that has one.
 */
function placeOf(source: string, line: number): string {
  const rest = source.split('\n').slice(line - 1);
  const mark = rest.map((each) => / \/\/ @(\S+:\d+)$/.exec(each)?.[1]).find(Boolean);
  return mark === undefined ? '' : `shaders/${mark}: `;
}

function run(program: string, words: string[], folder: string): Promise<Outcome> {
  return new Promise((resolve) => {
    execFile(program, words, { cwd: folder }, (error, stdout, stderr) => {
      const status = error === null ? 0 : typeof error.code === 'number' ? error.code : 1;
      resolve({ status, output: stdout + stderr });
    });
  });
}

async function checkAll(validator: string): Promise<void> {
  const programs = listPrograms(await Promise.all(kernels.map(({ load }) => load())));
  const folder = path.join(cacheFolder, `shaders-${process.pid}`);
  const wrong = new Map<string, string[]>();
  const waiting = [...programs.entries()];
  const work = async (): Promise<void> => {
    for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
      const [index, make] = next;
      const program = make();
      for (const message of await check(validator, program, path.join(folder, `${index}`))) {
        wrong.set(message, [...(wrong.get(message) ?? []), program.name]);
      }
    }
  };
  try {
    await Promise.all(Array.from({ length: availableParallelism() }, work));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  // An error in a shared file occurs in many programs, and is reported once.
  for (const [message, names] of wrong) {
    const others = names.length > 1 ? ` and ${names.length - 1} more` : '';
    console.log(`${message}\n  in ${names[0] ?? ''}${others}`);
  }
  console.log(`${programs.length} programs, ${wrong.size} problems`);
  if (wrong.size > 0) process.exitCode = 1;
}

const validator = findOnPath(['glslangValidator', 'glslang']);
if (validator === undefined) {
  console.log('skipped: glslangValidator is not installed (Debian: glslang-tools)');
} else {
  await checkAll(validator);
}
