import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import { Failure } from '../../core/failure.ts';

/** Parts of about this size leave the memory of scripts, in bytes. */
const partBytes = 2 ** 22;
/** What an archive without extensions can hold. */
const [mostFiles, mostBytes] = [65_535, 2 ** 32 - 1];

/** An archive that grows file by file. What is written is kept as blobs, which browsers may store. */
export class GrowingZip {
  private readonly zip: Zip;
  private readonly parts: Blob[] = [];
  private loose: Uint8Array<ArrayBuffer>[] = [];
  private looseBytes = 0;
  private bytes = 0;
  private files = 0;

  constructor() {
    this.zip = new Zip((error, chunk) => {
      if (error) throw error;
      this.loose.push(chunk);
      this.looseBytes += chunk.length;
      this.bytes += chunk.length;
      if (this.looseBytes >= partBytes) this.settle();
    });
  }

  /** @param pack false for files that are compressed already */
  add(name: string, bytes: Uint8Array, pack: boolean): void {
    const file = pack ? new ZipDeflate(name) : new ZipPassThrough(name);
    this.zip.add(file);
    file.push(bytes, true);
    if (++this.files > mostFiles || this.bytes > mostBytes) {
      throw new Failure('An archive holds at most 65,535 files and 4 GB; choose fewer frames');
    }
  }

  finish(): Blob {
    this.zip.end();
    this.settle();
    return new Blob(this.parts, { type: 'application/zip' });
  }

  /** Forgets what was written. */
  close(): void {
    this.parts.length = 0;
    this.loose = [];
  }

  private settle(): void {
    this.parts.push(new Blob(this.loose));
    this.loose = [];
    this.looseBytes = 0;
  }
}

/** Names of files in the order of frames: "frame-0007.png". */
export function frameName(word: string, index: number, count: number, ending: string): string {
  const digits = Math.max(4, String(count - 1).length);
  return `${word}-${String(index).padStart(digits, '0')}${ending}`;
}
