/** What this browser keeps between visits, each kind in a store of its own, by name. */
type StoreName = 'recent';

const database = { name: 'sinew', version: 1 };

/**
 * Runs a request in a store of the browser's own database. Returns undefined if the browser keeps
 * nothing, as some do in private windows; the page works all the same.
 */
export async function inStore<Result>(
  name: StoreName,
  mode: IDBTransactionMode,
  request: (store: IDBObjectStore) => IDBRequest,
): Promise<Result | undefined> {
  try {
    const opened = await open();
    try {
      return (await settled(request(opened.transaction(name, mode).objectStore(name)))) as Result;
    } finally {
      opened.close();
    }
  } catch {
    return undefined;
  }
}

function open(): Promise<IDBDatabase> {
  const opening = indexedDB.open(database.name, database.version);
  opening.onupgradeneeded = () => opening.result.createObjectStore('recent', { keyPath: 'name' });
  return settled(opening);
}

function settled<Result>(request: IDBRequest<Result>): Promise<Result> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('the database failed'));
  });
}
