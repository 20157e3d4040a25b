/** Typed arrays that grow while a file is read. */
type Numbers = Float32Array | Float64Array | Uint32Array | Int32Array | Uint16Array;

class Growable<T extends Numbers> {
  length = 0;
  private storage: T;
  private readonly create: (length: number) => T;

  constructor(create: (length: number) => T, capacity: number) {
    this.create = create;
    this.storage = create(capacity);
  }

  push(value: number): void {
    this.reserve(1)[this.length++] = value;
  }

  /**
   * Returns the values with room for `count` more, to be written from `length` on; `length` is set
   * by whoever writes them. This is faster than `push`, which serves all kinds of numbers.
   */
  reserve(count: number): T {
    const needed = this.length + count;
    if (needed > this.storage.length) {
      const larger = this.create(Math.max(needed, this.storage.length * 2));
      larger.set(this.storage);
      this.storage = larger;
    }
    return this.storage;
  }

  /** Adds a value until there are `length` of them. */
  padTo(length: number, value: number): void {
    if (this.length >= length) return;
    this.reserve(length - this.length).fill(value, this.length, length);
    this.length = length;
  }

  at(index: number): number {
    return this.storage[index]!;
  }

  /** The values that were added. They are not copied, and their buffer may be larger. */
  finish(): T {
    return this.storage.subarray(0, this.length) as T;
  }
}

const usualCapacity = 1024;

export function growFloat32(capacity = usualCapacity): Growable<Float32Array> {
  return new Growable((length) => new Float32Array(length), capacity);
}

export function growUint32(capacity = usualCapacity): Growable<Uint32Array> {
  return new Growable((length) => new Uint32Array(length), capacity);
}

export function growInt32(capacity = usualCapacity): Growable<Int32Array> {
  return new Growable((length) => new Int32Array(length), capacity);
}

export function growUint16(capacity = usualCapacity): Growable<Uint16Array> {
  return new Growable((length) => new Uint16Array(length), capacity);
}
