import type { CharacterState, Document } from './document.ts';

/** One step of undo: the documents before and after share all that did not change. */
export interface HistoryEntry {
  readonly label: string;
  readonly before: Document;
  readonly after: Document;
}

/** What can be undone and redone, newest last; a value like the document. */
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
  return before.characters
    .filter((state) => !after.characters.includes(state))
    .reduce((sum, state) => sum + sizeOfReplaced(state, after), 0);
}

function sizeOfReplaced(state: CharacterState, after: Document): number {
  const { character, q, morphWeights } = state;
  if (after.characters.some((each) => each.character === character))
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
