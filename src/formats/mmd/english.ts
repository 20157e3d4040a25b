import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { MmdEnglish } from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import { decodeName } from './decode-name.ts';

/** The numbers of names: as many as in Japanese, except for the base morph. */
export interface NameCounts {
  readonly bones: number;
  readonly morphs: number;
  readonly groups: number;
}

/** Reads the English names; `null` if the file has none. */
export function readEnglish(
  reader: BinaryReader,
  counts: NameCounts,
  log: DiagnosticLog,
  effect: string,
): MmdEnglish | null | undefined {
  const { offset } = reader;
  const flag = reader.integer(1, 'whether there are English names');
  if (flag === 0) return null;
  if (flag !== 1) {
    if (flag !== undefined) {
      const expected = '0 or 1, whether there are English names';
      log.warn({ code: 'pmd/section', offset, expected, found: `${flag}`, effect });
    }
    return undefined;
  }
  const head = reader.record(276, 'the English name and comment');
  const boneNames = head && readNames(counts.bones, 20, 'bones');
  const morphNames = boneNames && readNames(Math.max(0, counts.morphs - 1), 20, 'morphs');
  const groupNames = morphNames && readNames(counts.groups, 50, 'groups');
  if (!groupNames) return undefined;
  return {
    modelName: decodeName(head.bytes(0, 20)),
    comment: decodeName(head.bytes(20, 256)),
    boneNames,
    morphNames,
    groupNames,
  };

  function readNames(count: number, size: number, of: string): string[] | undefined {
    const names = reader.record(count * size, `the English names of ${of}`);
    if (!names) return undefined;
    return Array.from({ length: count }, (_, index) => decodeName(names.bytes(index * size, size)));
  }
}
