import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import type { Character } from '../core/character.ts';
import { hasErrors } from '../core/diagnostics.ts';
import type { Mesh } from '../core/mesh.ts';
import { createActor, type KeptState } from '../document/scene.ts';
import { EvaluationPool } from '../evaluation/evaluation-pool.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import { truncationLines, truncationOf } from '../evaluation/truncation.ts';
import { extensionOf } from '../formats/file-entry.ts';
import { writeObj } from '../formats/obj/write-obj.ts';
import { readCharacters } from '../formats/read-characters.ts';
import {
  defaultDeformation,
  deformationOf,
  kernelById,
  kernelNamed,
  methods,
  normalWays,
} from '../skinning/registry.ts';
import type { Command } from './command.ts';
import { printDiagnostics, readFiles, unwritable, userPath } from './files.ts';
import { givenSettings } from './method-settings.ts';
import { joinValue, parseWords } from './parse-words.ts';
import { motionOf } from './motion-of.ts';
import { unusedMotion } from './read-motion-file.ts';
import { givenPose } from './read-pose-file.ts';
import { UsageError } from './usage-error.ts';
import { wasmKernel } from './wasm-kernel.ts';

const methodIds = methods.map(({ short }) => short).join('|');
const normalsIds = normalWays.map(({ id }) => id).join('|');

/**
 * `pose FILES [--pose POSE] [--motion MOTION --time T] --out OUT` writes posed vertices in the file's order and units, in
 * Sinew's right-handed space or, with `--keep-file-space`, in the space of the file. An OBJ gets
 * normals if `--normals` says which. With `--influences`, it prints how far the vertices are from where
 * all of their influences put them.
 */
export const pose: Command = {
  name: 'pose',
  usage:
    `pose FILES [--pose POSE.json|POSE.vpd] [--motion MOTION.json|CLIP.anim --time T] [--method ${methodIds}] [--set NAME=VALUE] [--normals ${normalsIds}] [--influences K] [--normalize] [--keep-file-space]` +
    ' --out OUT.obj|OUT.f32',
  summary:
    'Writes the posed vertices of one character, in the order and the units of its file, as an OBJ mesh or as raw floats. The pose is that of --pose, or of the file, with what --motion moves as it is at --time, in seconds. --method takes short and long names, and --set gives a parameter of the method a value, as blend=0.5. An OBJ has normals if --normals says which. With --influences only the K strongest weights of each vertex are kept, and the error that this makes is printed.',
  async run(words) {
    const options = parseOptions(words);
    const methodSettings = await givenSettings(
      [kernelById(options.method ?? 'linear-blend')],
      options.set,
    );
    const { files, diagnostics: missing } = readFiles(options.files);
    const { characters, diagnostics } = await readCharacters(files);
    const found = [...missing, ...diagnostics];
    const character = characters[0]?.character;
    const posed = character && (await givenPose(options.pose, character, found));
    const motion =
      character && options.motion !== undefined
        ? await motionOf(options.motion, character)
        : { diagnostics: [] };
    found.push(...motion.diagnostics);
    printDiagnostics(found);
    if (hasErrors(motion.diagnostics)) console.error(unusedMotion);
    if (characters.length > 1) throw new UsageError('expected the files of one character');
    if (!character || character.mesh.pointCount === 0 || !posed || hasErrors(found)) {
      if (character?.mesh.pointCount === 0) console.error('error: there is no mesh to pose');
      return 1;
    }
    const evaluation = await evaluate(
      character,
      { ...posed, ...motion.value, methodSettings },
      options,
    );
    if (!writeOut(options.out, bytesOf(evaluation, options))) return 1;
    const truncation = truncationOf(evaluation);
    if (truncation) console.log(truncationLines(truncation).join('\n'));
    return 0;
  },
};

type Options = ReturnType<typeof parseOptions>;

function parseOptions(words: readonly string[]) {
  const { values, positionals: files } = parseWords(() =>
    parseArgs({
      args: joinValue(words, '--time'),
      options: {
        pose: { type: 'string' },
        motion: { type: 'string' },
        time: { type: 'string' },
        method: { type: 'string' },
        set: { type: 'string', multiple: true, default: [] },
        normals: { type: 'string' },
        influences: { type: 'string' },
        normalize: { type: 'boolean', default: false },
        'keep-file-space': { type: 'boolean', default: false },
        out: { type: 'string' },
      },
      allowPositionals: true,
    }),
  );
  const { pose: posePath, motion, method, set, normals, out, normalize } = values;
  if (files.length === 0) throw new UsageError('expected files, found none');
  if (posePath === undefined && motion === undefined) {
    throw new UsageError('expected --pose POSE.json or POSE.vpd, or --motion with --time');
  }
  if ((motion === undefined) !== (values.time === undefined)) {
    throw new UsageError('expected --motion and --time together');
  }
  const time = values.time?.trim() ? Number(values.time) : NaN;
  if (values.time !== undefined && !Number.isFinite(time)) {
    throw new UsageError(`expected --time in seconds, found "${values.time}"`);
  }
  // The id of a kernel such as `joint-normals` stands for its method and its way of normals.
  const kernel = method === undefined ? undefined : kernelNamed(method);
  if (method !== undefined && !kernel)
    throw new UsageError(`expected ${methodIds}, found "${method}"`);
  const way = normalWays.find(({ id }) => id === normals)?.id;
  if (normals !== undefined && !way)
    throw new UsageError(`expected ${normalsIds}, found "${normals}"`);
  const influences = values.influences === undefined ? null : Number(values.influences);
  if (influences !== null && !(Number.isInteger(influences) && influences >= 1)) {
    throw new UsageError(`expected --influences 1 or more, found "${values.influences}"`);
  }
  const extension = extensionOf(out ?? '');
  if (out === undefined || (extension !== '.obj' && extension !== '.f32')) {
    throw new UsageError('expected --out with a name that ends in .obj or .f32');
  }
  const keepFileSpace = values['keep-file-space'];
  const deformation = { method: kernel?.id, set, normals: way, normalize, influences };
  return { files, pose: posePath, motion, time, ...deformation, keepFileSpace, out };
}

async function evaluate(
  character: Character,
  posed: KeptState,
  options: Options,
): Promise<Evaluation> {
  const deformation = options.method
    ? deformationOf(options.method)
    : defaultDeformation(character);
  const { method, normals } = {
    ...deformation,
    ...(options.normals && { normals: options.normals }),
  };
  const { normalize: normalizeWeights, influences } = options;
  const kept = { ...posed, normals, normalizeWeights, influences };
  // The file's own pose model has no linked rotations; they belong to the page.
  const plain = { ...character, rotationLinks: [] };
  const actor = createActor(1, plain, method, kept);
  const pool = new EvaluationPool();
  await pool.kernels.loadFor(actor);
  pool.kernels.wasm = await wasmKernel();
  return new Evaluator(actor, pool).evaluate(
    actor,
    options.motion === undefined ? 0 : options.time,
  );
}

function bytesOf(evaluation: Evaluation, options: Options): Uint8Array {
  const { character } = evaluation.state;
  const skinned = evaluation.vertices();
  const isMirrored = options.keepFileSpace && character.meta.fileSpace === 'left-handed';
  const mesh = isMirrored ? flipped(character.mesh) : character.mesh;
  const positions = isMirrored ? mirrored(skinned.positions) : skinned.positions;
  if (extensionOf(options.out) === '.obj') {
    const asked = options.normals ? skinned.normals : null;
    return writeObj(mesh, { positions, normals: asked && isMirrored ? mirrored(asked) : asked });
  }
  const bytes = new DataView(new ArrayBuffer(mesh.pointCount * 12));
  for (let i = 0; i < mesh.pointCount * 3; i++) bytes.setFloat32(i * 4, positions[i]!, true);
  return new Uint8Array(bytes.buffer);
}

/** Reverses the triangles, for a left-handed file. */
function flipped(mesh: Mesh): Mesh {
  const indices = mesh.indices.slice();
  for (let i = 0; i < indices.length; i += 3) {
    [indices[i + 1], indices[i + 2]] = [indices[i + 2]!, indices[i + 1]!];
  }
  return { ...mesh, indices };
}

/** Negates z, for a left-handed file. */
function mirrored(triples: Float32Array): Float32Array {
  return triples.map((value, i) => (i % 3 === 2 ? 0 - value : value));
}

function writeOut(path: string, bytes: Uint8Array): boolean {
  try {
    writeFileSync(userPath(path), bytes);
    return true;
  } catch (error) {
    printDiagnostics([unwritable(path, error)]);
    return false;
  }
}
