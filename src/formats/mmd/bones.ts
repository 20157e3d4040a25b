import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { MmdBoneType, type MmdBone } from './mmd-parts.ts';
import { noParent } from '../../core/skeleton.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import type { BinaryRecord } from '../binary/binary-record.ts';
import { boundText } from '../text/bound-text.ts';
import { decodeName } from './decode-name.ts';
import { Findings } from './findings.ts';
import { mirrorPoint } from './mirror.ts';

/** A bone of a PMD. It is a joint: a point that can be the parent of others. */
export interface PmdBone extends MmdBone {
  readonly name: string;
  /** Offset of its parent's index in the file, for messages. */
  readonly parentOffset: number;
  /** File index as stored, -1 for a root. Whether that bone exists is checked later. */
  readonly parent: number;
}

const size = 39;
const none = 0xffff;

/** Reads `count × (name, parent, tail, type, IK parent, position of the head)`. */
export function readBones(
  reader: BinaryReader,
  largest: number,
  log: DiagnosticLog,
  effect: string,
): PmdBone[] | undefined {
  const array = reader.array(2, size, 'bones');
  if (!array) return undefined;
  const { count, offset, records } = array;
  if (count === 0) {
    const without = 'the mesh stands still';
    log.warn({ code: 'pmd/empty', offset, expected: 'bones', found: 'none', effect: without });
  }
  const findings = new BoneFindings();
  const bones = Array.from({ length: count }, (_, index) => {
    const head = headOf(records, index, largest, log, effect);
    return readBone(records, index, count, head, findings);
  });
  findings.warn(log, count);
  warnOfShortLinks(bones, log);
  return bones;
}

class BoneFindings {
  readonly types = new Findings();
  readonly tails = new Findings();
  readonly ikParents = new Findings();

  warn(log: DiagnosticLog, count: number): void {
    const range = `bones from 0 to ${count - 1}`;
    this.types.warn(log, 'pmd/unknown', 'types of bones from 0 to 9', 'they turn like others');
    this.tails.warn(log, 'pmd/index', `${range} as tails`, 'they have no tail');
    this.ikParents.warn(log, 'pmd/index', `${range} as IK parents`, 'they are not linked');
  }
}

function readBone(
  records: BinaryRecord,
  index: number,
  count: number,
  head: PmdBone['head'],
  findings: BoneFindings,
): PmdBone {
  const at = index * size;
  const offset = records.offset + at;
  const parent = records.u16(at + 20);
  const type = records.u8(at + 24);
  if (type > MmdBoneType.rotationLink) findings.types.add(offset + 24, `${type}, bone ${index}`);
  return {
    name: decodeName(records.bytes(at, 20)),
    parent: parent === none ? noParent : parent,
    parentOffset: offset + 20,
    tail: tailOf(),
    type,
    ikParent: ikParentOf(),
    head,
  };

  /** An absent tail and bone 0, which is usually the root, count as no tail, without a message. */
  function tailOf(): number {
    const tail = records.u16(at + 22);
    if (tail === 0 || tail === none) return -1;
    if (tail < count && tail !== index) return tail;
    findings.tails.add(offset + 22, `${tail}, bone ${index}`);
    return -1;
  }

  function ikParentOf(): number {
    const found = records.u16(at + 25);
    if (type === MmdBoneType.rotationLink) return found; // a percentage
    if (found === none) return -1;
    const isUsed = type === MmdBoneType.underIk || type === MmdBoneType.underRotation;
    if (found < count || !isUsed) return found;
    findings.ikParents.add(offset + 25, `${found}, bone ${index}`);
    return -1;
  }
}

function headOf(
  records: BinaryRecord,
  index: number,
  largest: number,
  log: DiagnosticLog,
  effect: string,
): PmdBone['head'] {
  const at = index * size + 27;
  const head = records.triple(at);
  const axis = head.findIndex((value) => !(Math.abs(value) <= largest));
  if (axis >= 0) {
    const offset = records.offset + at + axis * 4;
    const found = `${head[axis]!}, bone ${index}`;
    if (Number.isFinite(head[axis])) {
      const expected = `a position within ±${boundText(largest)}`;
      log.error({ code: 'pmd/range', offset, expected, found, effect });
    } else log.error({ code: 'pmd/number', offset, expected: 'a position', found, effect });
  }
  return mirrorPoint(head);
}

/** A bone between two joints at the same point has no direction of its own. */
function warnOfShortLinks(bones: readonly PmdBone[], log: DiagnosticLog): void {
  const short = new Findings();
  bones.forEach(({ parent, head, parentOffset }, index) => {
    const other = bones[parent]?.head;
    if (!other || parent === index) return;
    if (head.every((value, axis) => value === other[axis])) {
      short.add(parentOffset, `bones ${parent} and ${index}`);
    }
  });
  const effect = "the frame between them takes its parent's direction";
  short.warn(log, 'pmd/coincident', 'bones apart from their parents', effect);
}
