/**
 * A run of bytes that exists in the file, so that reads within it need no check. Little-endian;
 * offsets count from the record's start.
 */
export class BinaryRecord {
  /** Offset of its first byte in the file, for messages. */
  readonly offset: number;
  private readonly view: DataView;

  constructor(bytes: Uint8Array, offset: number, size: number) {
    this.offset = offset;
    this.view = new DataView(bytes.buffer, bytes.byteOffset + offset, size);
  }

  u8(at: number): number {
    return this.view.getUint8(at);
  }

  u16(at: number): number {
    return this.view.getUint16(at, true);
  }

  u32(at: number): number {
    return this.view.getUint32(at, true);
  }

  f32(at: number): number {
    return this.view.getFloat32(at, true);
  }

  triple(at: number): [number, number, number] {
    return [this.f32(at), this.f32(at + 4), this.f32(at + 8)];
  }

  /** A view, not a copy. */
  bytes(at: number, size: number): Uint8Array {
    return new Uint8Array(this.view.buffer, this.view.byteOffset + at, size);
  }
}
