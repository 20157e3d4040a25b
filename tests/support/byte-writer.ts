/** Little-endian bytes, one after another. */
export class ByteWriter {
  private readonly bytes: number[] = [];

  get size(): number {
    return this.bytes.length;
  }

  u8(...values: readonly number[]): this {
    this.bytes.push(...values.map((value) => value & 0xff));
    return this;
  }

  u16(...values: readonly number[]): this {
    return this.words(2, values, (view, value) => view.setUint16(0, value, true));
  }

  u32(...values: readonly number[]): this {
    return this.words(4, values, (view, value) => view.setUint32(0, value, true));
  }

  f32(...values: readonly number[]): this {
    return this.words(4, values, (view, value) => view.setFloat32(0, value, true));
  }

  /**
   * A field of `size` with text (one byte per character) or bytes; a NUL and then 0xFD fill the
   * rest.
   */
  field(size: number, content: string | readonly number[]): this {
    const start =
      typeof content === 'string' ? Array.from(content, (c) => c.charCodeAt(0)) : [...content];
    const padding = new Array<number>(Math.max(0, size - start.length)).fill(0xfd);
    if (padding.length > 0) padding[0] = 0;
    this.bytes.push(...start.slice(0, size), ...padding);
    return this;
  }

  done(): Uint8Array {
    return Uint8Array.from(this.bytes);
  }

  private words(
    size: number,
    values: readonly number[],
    set: (view: DataView, value: number) => void,
  ): this {
    for (const value of values) {
      const word = new Uint8Array(size);
      set(new DataView(word.buffer), value);
      this.bytes.push(...word);
    }
    return this;
  }
}
