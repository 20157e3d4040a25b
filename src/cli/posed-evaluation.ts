import type { Character } from '../core/character.ts';
import { createActor, type KeptState } from '../document/scene.ts';
import { EvaluationPool } from '../evaluation/evaluation-pool.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import { Evaluator } from '../evaluation/evaluator.ts';
import type { MethodId } from '../skinning/method.ts';
import { wasmKernel } from './wasm-kernel.ts';

/** A pool with the kernel of WebAssembly, where there is one. */
export async function createPool(): Promise<EvaluationPool> {
  const pool = new EvaluationPool();
  pool.kernels.wasm = await wasmKernel();
  return pool;
}

/** A character with the file's own pose model: linked rotations belong to the page. */
export function plainCharacter(character: Character): Character {
  return { ...character, rotationLinks: [] };
}

/**
 * Evaluates a character by a method, when all that this needs is loaded and prepared.
 *
 * @param time of the bound clip, in seconds
 */
export async function posedEvaluation(
  pool: EvaluationPool,
  character: Character,
  method: MethodId,
  kept: KeptState,
  time = 0,
): Promise<Evaluation> {
  const actor = createActor(1, character, method, kept);
  await pool.kernels.loadFor(actor);
  return new Evaluator(actor, pool).evaluate(actor, time);
}
