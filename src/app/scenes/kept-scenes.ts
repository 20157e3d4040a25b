import { inTransaction, settled } from '../storage.ts';

/** A scene as this browser keeps it: the text of a scene file, and the hashes of its files. */
export interface KeptScene {
  readonly id: string;
  readonly name: string;
  /** When it was last changed, in milliseconds since 1970. */
  readonly time: number;
  readonly text: string;
  /** The SHA-256 of the user's own files, which are kept once, whatever scenes need them. */
  readonly hashes: readonly string[];
  /** Whether it could not be restored, so that it is not tried at each visit. */
  readonly isRefused?: boolean;
}

/** Older ones are forgotten, unless a page has them open. */
const mostScenes = 8;

/** The scenes that are kept, the last changed first. What is no such record is left out. */
export async function listKept(): Promise<readonly KeptScene[]> {
  const records = await inTransaction(['scenes'], 'readonly', (transaction) =>
    settled<unknown[]>(transaction.objectStore('scenes').getAll()),
  );
  return records.filter(isKeptScene).sort((a, b) => b.time - a.time);
}

/** The files of a scene by their hashes, as far as they are kept. */
export async function keptFiles({ hashes }: KeptScene): Promise<ReadonlyMap<string, Blob>> {
  const found = await inTransaction(['files'], 'readonly', (transaction) => {
    const store = transaction.objectStore('files');
    return Promise.all(hashes.map((hash) => settled<unknown>(store.get(hash))));
  });
  const entries = hashes.map((hash, at) => [hash, found[at]] as const);
  return new Map(entries.filter((entry): entry is [string, Blob] => entry[1] instanceof Blob));
}

/**
 * Keeps a scene with those of its files that are not kept yet. Scenes that are too many are removed,
 * and files that no scene needs any more; all of it happens, or nothing.
 *
 * @param isOpen whether a page has the scene of an id open
 * @throws DOMException if the browser keeps nothing, or has no room
 */
export async function keepScene(
  scene: KeptScene,
  files: ReadonlyMap<string, Blob>,
  isOpen: (id: string) => boolean,
): Promise<void> {
  await inTransaction(['scenes', 'files'], 'readwrite', async (transaction) => {
    const scenes = transaction.objectStore('scenes');
    for (const [hash, file] of files) transaction.objectStore('files').put(file, hash);
    scenes.put(scene);
    await removeSurplus(transaction, isOpen);
  });
}

export async function forgetScene(id: string): Promise<void> {
  await inTransaction(['scenes', 'files'], 'readwrite', async (transaction) => {
    transaction.objectStore('scenes').delete(id);
    await removeSurplus(transaction, () => true);
  });
}

async function removeSurplus(
  transaction: IDBTransaction,
  isOpen: (id: string) => boolean,
): Promise<void> {
  const [scenes, files] = [transaction.objectStore('scenes'), transaction.objectStore('files')];
  const [records, hashes] = await Promise.all([
    settled<unknown[]>(scenes.getAll()),
    settled<IDBValidKey[]>(files.getAllKeys()),
  ]);
  const kept = records.filter(isKeptScene).sort((a, b) => b.time - a.time);
  const surplus = kept.slice(mostScenes).filter(({ id }) => !isOpen(id));
  for (const { id } of surplus) scenes.delete(id);
  const needed = new Set(
    kept.filter((each) => !surplus.includes(each)).flatMap((each) => each.hashes),
  );
  for (const hash of hashes) if (!needed.has(hash as string)) files.delete(hash);
}

function isKeptScene(value: unknown): value is KeptScene {
  if (typeof value !== 'object' || value === null) return false;
  const { id, name, time, text, hashes } = value as Partial<Record<keyof KeptScene, unknown>>;
  return (
    [id, name, text].every((each) => typeof each === 'string') &&
    Number.isFinite(time) &&
    Array.isArray(hashes) &&
    hashes.every((hash) => typeof hash === 'string')
  );
}
