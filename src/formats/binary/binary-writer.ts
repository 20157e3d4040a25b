/** Writes little-endian numbers and bytes, one after another, into a buffer that grows. */
export class BinaryWriter {
  private view = new DataView(new ArrayBuffer(64 * 1024));
  private length = 0;

  u8(...values: readonly number[]): void {
    for (const value of values) {
      const at = this.advance(1);
      this.view.setUint8(at, value);
    }
  }

  u16(...values: readonly number[]): void {
    for (const value of values) {
      const at = this.advance(2);
      this.view.setUint16(at, value, true);
    }
  }

  u32(...values: readonly number[]): void {
    for (const value of values) {
      const at = this.advance(4);
      this.view.setUint32(at, value, true);
    }
  }

  f32(...values: readonly number[]): void {
    for (const value of values) {
      const at = this.advance(4);
      this.view.setFloat32(at, value, true);
    }
  }

  bytes(values: Uint8Array): void {
    const at = this.advance(values.length);
    new Uint8Array(this.view.buffer).set(values, at);
  }

  /** Returns a copy of what was written. */
  done(): Uint8Array {
    return new Uint8Array(this.view.buffer).slice(0, this.length);
  }

  /** Makes room for more bytes, perhaps in a new view, and returns where they start. */
  private advance(size: number): number {
    const at = this.length;
    this.length += size;
    if (this.length > this.view.byteLength) {
      const larger = new Uint8Array(Math.max(this.length, this.view.byteLength * 2));
      larger.set(new Uint8Array(this.view.buffer));
      this.view = new DataView(larger.buffer);
    }
    return at;
  }
}
