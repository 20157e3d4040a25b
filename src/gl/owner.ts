/** Holds objects that must be disposed of together, so that none is forgotten if a step fails. */
export class Owner {
  private readonly owned: { dispose(): void }[] = [];

  own<T extends { dispose(): void }>(object: T): T {
    this.owned.push(object);
    return object;
  }

  /** Disposes of all objects, the newest first. */
  dispose(): void {
    for (const object of this.owned.splice(0).reverse()) object.dispose();
  }
}
