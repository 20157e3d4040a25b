/** Parts of about this size leave the memory of scripts, in bytes. */
const partBytes = 2 ** 22;

/** Bytes and where they are in a file. */
interface Write {
  readonly data: Uint8Array<ArrayBuffer>;
  readonly position: number;
}

/**
 * A file that mostly grows at its end. What is written is kept as blobs, which browsers may store; the
 * few bytes that are written again, as a length in a header, are put in at the end.
 */
export class GrowingFile {
  private readonly parts: Blob[] = [];
  private readonly patches: Write[] = [];
  private loose: Uint8Array<ArrayBuffer>[] = [];
  private looseBytes = 0;
  private bytes = 0;

  write({ data, position }: Write): void {
    if (position > this.bytes) this.append(new Uint8Array(position - this.bytes));
    const known = Math.min(data.length, this.bytes - position);
    if (known > 0) this.patches.push({ data: data.slice(0, known), position });
    if (known < data.length) this.append(data.slice(known));
  }

  finish(type: string): Blob {
    this.settle();
    let file = new Blob(this.parts, { type });
    for (const { data, position } of this.patches) {
      const after = position + data.length;
      file = new Blob([file.slice(0, position), data, file.slice(after)], { type });
    }
    return file;
  }

  /** Forgets what was written. */
  close(): void {
    this.parts.length = 0;
    this.patches.length = 0;
    this.loose = [];
  }

  private append(data: Uint8Array<ArrayBuffer>): void {
    this.loose.push(data);
    this.looseBytes += data.length;
    this.bytes += data.length;
    if (this.looseBytes >= partBytes) this.settle();
  }

  private settle(): void {
    this.parts.push(new Blob(this.loose));
    this.loose = [];
    this.looseBytes = 0;
  }
}
