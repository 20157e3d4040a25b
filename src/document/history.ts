import type { Actor, Scene } from './scene.ts';

/** One step of undo: the documents before and after share all that did not change. */
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

/** Bytes that only this step keeps alive: what is in `before` and no longer in `after`. */
function sizeOf({ before, after }: HistoryEntry): number {
  return before.actors
    .filter((actor) => !after.actors.includes(actor))
    .reduce((sum, actor) => sum + sizeOfReplaced(actor, after), 0);
}

function sizeOfReplaced(actor: Actor, after: Scene): number {
  const { character, q, morphWeights } = actor;
  if (after.actors.some((each) => each.character === character))
    return q.byteLength + morphWeights.byteLength;
  const { mesh, skin } = character;
  const arrays = [mesh.positions, mesh.normals, mesh.indices, mesh.pointOf, mesh.uvs];
  const weights = [skin.start, skin.entries, skin.weights, skin.jointFromBind];
  const images = character.images.map(({ bytes }) => bytes);
  return [...arrays, ...weights, ...images].reduce(
    (sum, array) => sum + (array?.byteLength ?? 0),
    0,
  );
}
