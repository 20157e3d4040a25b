import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import { isLfsPointer, lfsPointer } from '../text/lfs-pointer.ts';

/** The beginnings of other files, and the message for each. */
const others: readonly (readonly [pattern: RegExp, hint: string])[] = [
  [/^PMX /i, 'PMX is not supported'],
  [/^Vocaloid Motion/, 'this is a motion file'],
  [/^Vocaloid Pose/, 'this is a pose file'],
  [/^(PK[\x01-\x08]|Rar!|7z\xbc\xaf|\x1f\x8b)/, 'this is an archive: unpack it first'],
  [/^\s*<(!doctype|!--|html|head|body|\?xml)/i, 'this is a web page'],
  [/^\s*[{[]/, 'this looks like JSON'],
];

/** Reads "Pmd", or reports what the file seems to be. */
export function readSignature(
  reader: BinaryReader,
  bytes: Uint8Array,
  log: DiagnosticLog,
  effect: string,
): boolean {
  if (isLfsPointer(bytes)) {
    log.error({ ...lfsPointer, effect });
    return false;
  }
  const record = reader.record(3, '"Pmd"');
  if (!record) return false;
  const found = characters(record.bytes(0, 3));
  if (found === 'Pmd') return true;
  const start = characters(bytes.subarray(0, 64));
  const hint = others.find(([pattern]) => pattern.test(start))?.[1];
  const expected = hint === undefined ? '"Pmd"' : `"Pmd" (${hint})`;
  log.error({ code: 'pmd/magic', offset: 0, expected, found, effect });
  return false;
}

/** One character per byte. */
function characters(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes);
}
