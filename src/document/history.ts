import { buffersOf } from '../core/buffers-of.ts';
import type { Character } from '../core/character.ts';
import type { ChannelParts } from '../core/motion/clip-parts.ts';
import { type Actor, type Scene, skinInUse } from './scene.ts';

/** One step of undo. The scenes before and after share everything that did not change. */
export interface HistoryEntry {
  readonly label: string;
  readonly before: Scene;
  readonly after: Scene;
}

/** The steps that can be undone and redone, the newest last; a value like the scene. */
export interface History {
  readonly past: readonly HistoryEntry[];
  readonly future: readonly HistoryEntry[];
}

export const emptyHistory: History = { past: [], future: [] };

const defaultMemoryLimit = 256 * 1024 * 1024;

/** Adds a step and clears the redo steps. Drops the oldest steps beyond the memory limit. */
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

/** All steps, the oldest first; of these, `past.length` have been taken. */
export function allSteps({ past, future }: History): readonly HistoryEntry[] {
  return [...past, ...[...future].reverse()];
}

/** The history in which so many of its steps have been taken, and the scene after the last one. */
export function stepTo(history: History, count: number): readonly [History, Scene] {
  const all = allSteps(history);
  const past = all.slice(0, count);
  const future = all.slice(count);
  return [{ past, future: future.reverse() }, past.at(-1)?.after ?? all[0]!.before];
}

/** Replaces the present scene in the steps on both sides of it. */
export function replacePresent({ past, future }: History, present: Scene): History {
  const [last, next] = [past.at(-1), future.at(-1)];
  return {
    past: last ? [...past.slice(0, -1), { ...last, after: present }] : past,
    future: next ? [...future.slice(0, -1), { ...next, before: present }] : future,
  };
}

/** The bytes that only this step keeps in memory: what `before` has and `after` does not use. */
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
  const buffers = [...own].reduce((sum, buffer) => sum + buffer.byteLength, 0);
  const kept = new Set(after.actors.flatMap(channelsOfActor));
  const channels = new Set(replaced.flatMap(channelsOfActor).filter((each) => !kept.has(each)));
  return [...channels].reduce((sum, { keys }) => sum + keys.length * keyBytes, buffers);
}

/** About what a key takes in memory: its object with two numbers, and its part of the curve. */
const keyBytes = 160;

function channelsOfActor({ clips }: Actor): ChannelParts[] {
  return clips.flatMap(({ channels }) => channels);
}

/** All buffers of an actor's character, of its look and of the weights that are computed from it. */
function buffersOfActor(actor: Actor): ArrayBuffer[] {
  const { q, morphWeights, look, skin, character } = actor;
  const own = buffersOf([q, morphWeights, look, skin, skinInUse(actor)]);
  return [...own, ...buffersOfCharacter(character)];
}

function buffersOfCharacter(character: Character): readonly ArrayBuffer[] {
  let found = knownBuffers.get(character);
  if (!found) knownBuffers.set(character, (found = buffersOf(character)));
  return found;
}

const knownSizes = new WeakMap<HistoryEntry, number>();
const knownBuffers = new WeakMap<Character, readonly ArrayBuffer[]>();
