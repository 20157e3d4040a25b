/**
 * While a page has a scene open, it holds a lock of the scene's id, so that no other page writes to
 * the same record. The browser releases it when the page ends in whatever way.
 */
const prefix = 'sinew scene ';

/**
 * Takes the lock of a scene until the page ends or the lock is released; returns nothing if another
 * page has it, or if the browser has no locks.
 *
 * @param patience in milliseconds, for a page that is about to end
 */
export function holdScene(id: string, patience = 0): Promise<(() => void) | undefined> {
  const locks = lockManager();
  if (!locks) return Promise.resolve(undefined);
  return new Promise((resolve) => {
    const hold = (lock: Lock | null): Promise<void> | undefined => {
      if (lock) return new Promise((release) => resolve(() => release()));
      resolve(undefined);
      return undefined;
    };
    const way = patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true };
    locks.request(prefix + id, way, hold).catch(() => resolve(undefined));
  });
}

/** Returns whether a scene is open in some page; of none, where the browser has no locks. */
export async function openScenes(): Promise<(id: string) => boolean> {
  const held = (await lockManager()?.query())?.held ?? [];
  const names = new Set(held.map(({ name }) => name));
  return (id) => names.has(prefix + id);
}

function lockManager(): LockManager | undefined {
  return (navigator as { readonly locks?: LockManager }).locks;
}
