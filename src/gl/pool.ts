interface Shared<T> {
  readonly value: T;
  users: number;
}

/** One user's hold on a shared object. */
export interface Lease<T> {
  readonly value: T;
  /** The last user's release disposes of the object. */
  release(): void;
}

/** Objects by what they are made of, so that what is made of the same is shared. */
export class Pool<K extends object, T extends { dispose(): void }> {
  private readonly shared = new Map<K, Shared<T>>();

  has(key: K): boolean {
    return this.shared.has(key);
  }

  /** @param create makes it where nobody holds it; what it throws is the caller's */
  lease(key: K, create: () => T): Lease<T> {
    let found = this.shared.get(key);
    if (!found) this.shared.set(key, (found = { value: create(), users: 0 }));
    const held = found;
    held.users++;
    let isHeld = true;
    return {
      value: held.value,
      release: () => {
        if (!isHeld) return;
        isHeld = false;
        if (--held.users > 0) return;
        this.shared.delete(key);
        held.value.dispose();
      },
    };
  }
}
