import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { scan, type Scanner } from './scanner.ts';

const about = { area: 'rig', effect: 'the files are grouped by their names' } as const;

/** The files of one character, as a `.rig` names them. */
export interface RigFile {
  readonly name: string;
  readonly skeleton?: string;
  readonly skin?: string;
  readonly morphs: readonly string[];
}

const isOuter = (word: string): boolean => word === 'rig';
const keywords = new Set(['skeleton', 'skin', 'morphs']);
const isKeyword = (word: string): boolean => keywords.has(word);

/** Reads a `.rig` of CSE169: `rig NAME { skeleton FILE skin FILE morphs N { FILE … } }`. */
export function readRig(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<RigFile> {
  const log = new DiagnosticLog(file);
  const scanner = scan(file, bytes, log, about, limits);
  if (!scanner) return log.finish<RigFile>(undefined);
  if (scanner.keyword(isOuter) !== 'rig') scanner.fail('token', '"rig"');
  let name = '';
  if (scanner.sound() && !scanner.openIfAny()) {
    name = readName(scanner, 'a name');
    if (scanner.sound()) scanner.open();
  }
  const rig = scanner.sound() ? readParts(scanner, name) : undefined;
  while (scanner.sound() && scanner.reader.next()) scanner.trailing(isOuter, 'nothing after it');
  scanner.checkEnd();
  return log.finish(rig);
}

function readParts(scanner: Scanner, name: string): RigFile {
  const { reader } = scanner;
  const found: { skeleton?: string; skin?: string; morphs: string[] } = { morphs: [] };
  while (scanner.sound()) {
    const word = scanner.keyword(isKeyword);
    if (reader.isClose) break;
    if (word === 'skeleton' || word === 'skin') found[word] = readName(scanner, 'a file');
    else if (word === 'morphs') found.morphs.push(...readMorphs(scanner));
    else if (reader.isWord) scanner.skipUnknown(isKeyword);
    else scanner.fail('token', '"}" for the rig');
  }
  return { name, ...found };
}

function readMorphs(scanner: Scanner): string[] {
  const count = scanner.count('morphs', 2, scanner.limits.jointCount);
  const opened = scanner.sound() && scanner.openIfAny();
  const names: string[] = [];
  for (let i = 0; i < count && scanner.sound(); i++) names.push(readName(scanner, 'a file'));
  if (scanner.sound()) scanner.close('the morphs', opened);
  return names;
}

function readName(scanner: Scanner, what: string): string {
  scanner.reader.next();
  if (scanner.reader.isWord) return scanner.reader.unquoted();
  scanner.fail('token', what);
  return '';
}
