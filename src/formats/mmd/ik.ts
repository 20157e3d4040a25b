import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { IkChain } from './mmd-parts.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import type { BinaryRecord } from '../binary/binary-record.ts';
import { Findings } from './findings.ts';

const headSize = 11;

/** Reads the IK chains; a chain that names a bone that does not exist is left out. */
export function readIkChains(
  reader: BinaryReader,
  boneCount: number,
  log: DiagnosticLog,
): IkChain[] | undefined {
  const { offset } = reader;
  const count = reader.integer(2, 'the number of IK chains');
  if (count === undefined || !reader.fits(count, headSize, 'IK chains', offset)) return undefined;
  const chains: IkChain[] = [];
  const findings = new Findings();
  for (let index = 0; index < count; index++) {
    const head = reader.record(headSize, `IK chain ${index}`);
    const linkCount = head?.u8(4) ?? 0;
    const links = head && reader.record(linkCount * 2, `the bones of IK chain ${index}`);
    if (!links) return undefined;
    const chain = chainOf(head, links, linkCount);
    const outside = [chain.goal, chain.effector, ...chain.links].find((bone) => bone >= boneCount);
    if (outside === undefined && Number.isFinite(chain.limit)) chains.push(chain);
    else findings.add(head.offset, `${outside ?? chain.limit}, IK chain ${index}`);
  }
  const expected = `IK chains of bones from 0 to ${boneCount - 1}`;
  findings.warn(log, 'pmd/index', expected, 'they are left out');
  return chains;
}

function chainOf(head: BinaryRecord, links: BinaryRecord, linkCount: number): IkChain {
  return {
    goal: head.u16(0),
    effector: head.u16(2),
    iterations: head.u16(5),
    limit: head.f32(7),
    links: Array.from({ length: linkCount }, (_, link) => links.u16(link * 2)),
  };
}
