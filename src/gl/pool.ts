interface Shared<K, T> {
  key: K;
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
  private readonly shared = new Map<K, Shared<K, T>>();

  has(key: K): boolean {
    return this.shared.has(key);
  }

  /** @param create makes it where nobody holds it; what it throws is the caller's */
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
   * Makes one object into another in place, under the leases that are out: where a single user holds
   * it, and nobody what it becomes.
   *
   * @param change changes the object, or returns false where it can't
   * @returns whether it was changed
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
