interface Shared<K, T> {
  key: K;
  readonly value: T;
  users: number;
}

/** One user's share of an object. */
export interface Lease<T> {
  readonly value: T;
  /** Ends the share. The last user's release disposes of the object. */
  release(): void;
}

/** Objects keyed by what they are made from, so that users of the same source share one object. */
export class Pool<K extends object, T extends { dispose(): void }> {
  private readonly shared = new Map<K, Shared<K, T>>();

  has(key: K): boolean {
    return this.shared.has(key);
  }

  /** @param create makes the object if nobody holds it; its exceptions go to the caller */
  lease(key: K, create: () => T): Lease<T> {
    let found = this.shared.get(key);
    if (!found) this.shared.set(key, (found = { key, value: create(), users: 0 }));
    const held = found;
    held.users++;
    let isHeld = true;
    return {
      value: held.value,
      release: () => {
        if (!isHeld) return;
        isHeld = false;
        if (--held.users > 0) return;
        this.shared.delete(held.key);
        held.value.dispose();
      },
    };
  }

  /**
   * Turns one object into another in place, under its existing leases. This needs that only one
   * user holds the object and that nobody holds the one that it becomes.
   *
   * @param change changes the object, or returns false if it can't
   * @returns whether the object was changed
   */
  convert(from: K, to: K, change: (value: T) => boolean): boolean {
    const held = this.shared.get(from);
    if (held?.users !== 1 || this.shared.has(to) || !change(held.value)) return false;
    this.shared.delete(from);
    this.shared.set(to, held);
    held.key = to;
    return true;
  }
}
