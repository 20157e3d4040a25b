import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import type { ReaderKind } from '../readers/sinew.ts';

/**
 * Reads the file that the process's words name, and prints by how many bytes that raised the peak of
 * its resident memory above what it held with the file's bytes in memory. A small file is read
 * before, so that the code is loaded. The words are KIND, FILE and SMALL_FILE.
 */
export async function probe(
  readers: Readonly<Record<ReaderKind, (bytes: Uint8Array) => unknown>>,
): Promise<void> {
  const [kind, file, smallFile] = process.argv.slice(2) as [ReaderKind, string, string];
  await readers[kind](bytesOf(smallFile));
  const bytes = bytesOf(file);
  forgetPeak();
  const before = process.memoryUsage.rss();
  const result = await readers[kind](bytes);
  if (!result) throw new Error(`${file} was not read`);
  console.log(peak() - before);
}

/** The bytes in a buffer of their own. */
function bytesOf(name: string): Uint8Array {
  return Uint8Array.from(readFileSync(name));
}

// On Linux the peak that Node reports is not below that of the process that started this one.
const ofKernel = { status: '/proc/self/status', reset: '/proc/self/clear_refs' };

function forgetPeak(): void {
  if (existsSync(ofKernel.reset)) writeFileSync(ofKernel.reset, '5');
}

/** The most bytes of resident memory so far. */
function peak(): number {
  if (!existsSync(ofKernel.status)) return process.resourceUsage().maxRSS * 1024;
  const [, kibibytes] = /^VmHWM:\s+(\d+) kB/m.exec(readFileSync(ofKernel.status, 'utf8')) ?? [];
  return Number(kibibytes) * 1024;
}
