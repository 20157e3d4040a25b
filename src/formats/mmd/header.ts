import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import { decodeName } from './decode-name.ts';

export interface PmdHeader {
  readonly version: number;
  readonly modelName: string;
  readonly comment: string;
}

/** All known files have this version. */
const knownVersion = 1;

/** Reads the version, name and comment after the signature. */
export function readHeader(
  reader: BinaryReader,
  log: DiagnosticLog,
  effect: string,
): PmdHeader | undefined {
  const version = reader.record(4, 'the version');
  if (!version || !checkVersion(version.f32(0), version.offset, log, effect)) return undefined;
  const name = reader.record(20, "the model's name");
  const comment = name && reader.record(256, 'the comment');
  if (!comment) return undefined;
  return {
    version: version.f32(0),
    modelName: decodeName(name.bytes(0, 20)),
    comment: decodeName(comment.bytes(0, 256)),
  };
}

/** A number far from 1 is not a version but other data, or comes from a big-endian machine. */
function checkVersion(
  version: number,
  offset: number,
  log: DiagnosticLog,
  effect: string,
): boolean {
  if (version === knownVersion) return true;
  const details = {
    code: 'pmd/version',
    offset,
    expected: 'version 1',
    found: `${Number(version.toPrecision(2))}`,
  } as const;
  const isLikely = version > 0.1 && version < 10;
  if (isLikely) log.warn({ ...details, effect: 'it is read as version 1' });
  else log.error({ ...details, effect });
  return isLikely;
}
