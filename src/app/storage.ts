/** What this browser keeps between visits, each kind in a store of its own. */
const stores = {
  recent: { keyPath: 'name' },
  scenes: { keyPath: 'id' },
  /** By SHA-256. */
  files: {},
} as const satisfies Record<string, IDBObjectStoreParameters>;

type StoreName = keyof typeof stores;

const database = { name: 'sinew', version: 2 };

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
    return await inTransaction([name], mode, (transaction) =>
      settled<Result>(request(transaction.objectStore(name))),
    );
  } catch {
    return undefined;
  }
}

/**
 * Runs a transaction, which is committed whole or not at all. The work may await nothing but its
 * own requests.
 *
 * @throws DOMException if the browser keeps nothing, or has no room
 */
export async function inTransaction<Result>(
  names: readonly StoreName[],
  mode: IDBTransactionMode,
  work: (transaction: IDBTransaction) => Promise<Result>,
): Promise<Result> {
  const opened = await open();
  try {
    const transaction = opened.transaction(names, mode);
    const [result] = await Promise.all([work(transaction), committed(transaction)]);
    return result;
  } finally {
    opened.close();
  }
}

export function settled<Result>(request: IDBRequest): Promise<Result> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result as Result);
    request.onerror = () => reject(request.error ?? new Error('the database failed'));
  });
}

function committed(transaction: IDBTransaction): Promise<void> {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new Error('the database failed'));
  });
}

async function open(): Promise<IDBDatabase> {
  const opening = indexedDB.open(database.name, database.version);
  opening.onupgradeneeded = () => {
    const { result } = opening;
    for (const [name, parameters] of Object.entries(stores)) {
      if (!result.objectStoreNames.contains(name)) result.createObjectStore(name, parameters);
    }
  };
  return settled(opening);
}
