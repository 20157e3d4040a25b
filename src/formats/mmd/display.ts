import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { MmdDisplay } from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import { decodeName } from './decode-name.ts';
import { Findings } from './findings.ts';

const groupNameSize = 50;

export const noDisplay: MmdDisplay = { morphs: [], groupNames: [], bones: [] };

/** Reads the order and groups in which a program lists morphs and bones. */
export function readDisplay(
  reader: BinaryReader,
  boneCount: number,
  morphCount: number,
  log: DiagnosticLog,
): MmdDisplay | undefined {
  const shown = reader.array(1, 2, 'listed morphs');
  const groups = shown && reader.array(1, groupNameSize, 'groups of bones');
  const listed = groups && reader.array(4, 3, 'listed bones');
  if (!listed) return undefined;
  const findings = new Findings();
  const morphs = indices(shown.count, (index) => shown.records.u16(index * 2)).filter(
    (morph, index) => isThere(morph, morphCount, 'morph', shown.records.offset + index * 2),
  );
  const bones = indices(listed.count, (index) => {
    return { bone: listed.records.u16(index * 3), group: listed.records.u8(index * 3 + 2) };
  }).filter(({ bone, group }, index) => {
    const offset = listed.records.offset + index * 3;
    return (
      isThere(bone, boneCount, 'bone', offset) &&
      isThere(group, groups.count + 1, 'group', offset + 2)
    );
  });
  const expected = 'lists of morphs, bones and groups that are there';
  findings.warn(log, 'pmd/index', expected, 'what is not is left out of them');
  const groupNames = indices(groups.count, (index) =>
    decodeName(groups.records.bytes(index * groupNameSize, groupNameSize)),
  );
  return { morphs, groupNames, bones };

  function isThere(index: number, count: number, what: string, offset: number): boolean {
    if (index < count) return true;
    findings.add(offset, `${what} ${index}`);
    return false;
  }
}

function indices<T>(length: number, at: (index: number) => T): T[] {
  return Array.from({ length }, (_, index) => at(index));
}
