import { type Actor, createActor } from '../document/scene.ts';
import { EvaluationPool } from '../evaluation/evaluation-pool.ts';
import type { MethodId } from '../skinning/method.ts';
import type { KernelRow } from '../skinning/registry.ts';
import { givenSettings } from './method-settings.ts';
import { readPosed } from './read-posed.ts';
import { wasmKernel } from './wasm-kernel.ts';

/** What a command that compares methods is given. */
interface ComparedWords {
  readonly files: readonly string[];
  /** The path of a pose, or none for that of the files. */
  readonly pose: string | undefined;
  readonly methods: readonly KernelRow<MethodId>[];
  readonly set: readonly string[];
  readonly normalize: boolean;
}

/**
 * Reads the character of a command that compares methods, in its pose. It has the file's own pose
 * model: linked rotations belong to the page. Prints problems of the files; returns nothing if they
 * keep the character from being used.
 */
export async function comparedActor(given: ComparedWords): Promise<Actor | undefined> {
  const methodSettings = await givenSettings(given.methods, given.set);
  const posed = await readPosed(given.files, given.pose);
  if (!posed) return undefined;
  const kept = { ...posed.pose, normalizeWeights: given.normalize, methodSettings };
  return createActor(1, { ...posed.character, rotationLinks: [] }, 'linear-blend', kept);
}

/**
 * Loads and prepares all that an actor's methods need; the pool has the kernel of WebAssembly, where
 * there is one.
 */
export async function preparedPool(
  actor: Actor,
  methods: readonly KernelRow<MethodId>[],
): Promise<EvaluationPool> {
  const pool = new EvaluationPool();
  pool.kernels.wasm = await wasmKernel();
  for (const { id: method } of methods) await pool.kernels.loadFor({ ...actor, method });
  return pool;
}

/** Does work that gives back the part that is done from time to time, to its end. */
export function finished<T>(work: Generator<number, T>): T {
  let result = work.next();
  while (!result.done) result = work.next();
  return result.value;
}
