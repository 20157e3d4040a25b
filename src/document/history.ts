import { buffersOf } from '../core/buffers-of.ts';
import type { Character } from '../core/character.ts';
import { type Actor, type Scene, skinInUse } from './scene.ts';

/** One step of undo: the scenes before and after share all that did not change. */
export interface HistoryEntry {
  readonly label: string;
  readonly before: Scene;
  readonly after: Scene;
}

/** What can be undone and redone, newest last; a value like the scene. */
export interface History {
  readonly past: readonly HistoryEntry[];
  readonly future: readonly HistoryEntry[];
}

export const emptyHistory: History = { past: [], future: [] };

const defaultMemoryLimit = 256 * 1024 * 1024;

/** Adds a step, forgets what was undone, and lets the oldest go past the memory limit. */
export function record(
  history: History,
  entry: HistoryEntry,
  memoryLimit = defaultMemoryLimit,
): History {
  const past = [...history.past, entry];
  let size = past.reduce((sum, each) => sum + sizeOf(each), 0);
  let forgotten = 0;
  while (size > memoryLimit && forgotten < past.length - 1) size -= sizeOf(past[forgotten++]!);
  return { past: past.slice(forgotten), future: [] };
}

export function stepBack({ past, future }: History): History {
  return { past: past.slice(0, -1), future: [...future, ...past.slice(-1)] };
}

export function stepForward({ past, future }: History): History {
  return { past: [...past, ...future.slice(-1)], future: future.slice(0, -1) };
}

/** Puts a scene in the place of the present one, in the steps on both of its sides. */
export function replacePresent({ past, future }: History, present: Scene): History {
  const [last, next] = [past.at(-1), future.at(-1)];
  return {
    past: last ? [...past.slice(0, -1), { ...last, after: present }] : past,
    future: next ? [...future.slice(0, -1), { ...next, before: present }] : future,
  };
}

/** Bytes that only this step keeps alive: buffers of `before` that `after` does not have. */
function sizeOf(entry: HistoryEntry): number {
  let size = knownSizes.get(entry);
  if (size === undefined) knownSizes.set(entry, (size = measure(entry)));
  return size;
}

function measure({ before, after }: HistoryEntry): number {
  const replaced = before.actors.filter((actor) => !after.actors.includes(actor));
  if (replaced.length === 0) return 0;
  const shared = new Set(after.actors.flatMap(buffersOfActor));
  const own = new Set(replaced.flatMap(buffersOfActor).filter((buffer) => !shared.has(buffer)));
  return [...own].reduce((sum, buffer) => sum + buffer.byteLength, 0);
}

/** Of its character all, with what was computed of it: the weights in use. */
function buffersOfActor(actor: Actor): ArrayBuffer[] {
  const { q, morphWeights, character } = actor;
  return [...buffersOf([q, morphWeights, skinInUse(actor)]), ...buffersOfCharacter(character)];
}

function buffersOfCharacter(character: Character): readonly ArrayBuffer[] {
  let found = knownBuffers.get(character);
  if (!found) knownBuffers.set(character, (found = buffersOf(character)));
  return found;
}

const knownSizes = new WeakMap<HistoryEntry, number>();
const knownBuffers = new WeakMap<Character, readonly ArrayBuffer[]>();
