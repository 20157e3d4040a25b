import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { checkText } from '../text/check-text.ts';
import { decodeVpd } from './decode-vpd.ts';
import { signature, type Vpd, type VpdBone, type VpdMorph } from './vpd-parts.ts';
import { bareText, textLines, type TextLine, VpdRows } from './vpd-rows.ts';

/** A block of the file: its head, such as `Bone3{頭`, and the lines up to its closing brace. */
interface Block {
  readonly kind: 'bone' | 'morph';
  readonly name: string;
  readonly head: TextLine;
  readonly rows: readonly TextLine[];
  /** Whether it has a closing brace. */
  readonly isClosed: boolean;
}

const blockHead = /^(Bone|Morph)\s*\d+\s*\{(.*)$/i;
const leftOut = 'this one is left out';

/**
 * Reads a pose of MikuMikuDance: `Vocaloid Pose Data file`, the model's name, the count of bones,
 * and a block for each bone and, in later versions, for each morph. A block that is damaged is
 * reported and left out.
 */
export function readVpd(file: string, bytes: Uint8Array): Parsed<Vpd> {
  const log = new DiagnosticLog(file);
  const text = checkText(file, bytes, log);
  if (!text) return log.finish<Vpd>(undefined);
  const lines = textLines(decodeVpd(text, text !== bytes, log));
  const start = readSignature(lines, log);
  if (start < 0) return log.finish<Vpd>(undefined);
  const header = readHeader(lines, start, log);
  const blocks = readBlocks(lines, header.next, log);
  const rows = new VpdRows(log, leftOut);
  const bones = blocks.flatMap((block) => boneOf(block, rows) ?? []);
  const morphs = blocks.flatMap((block) => morphOf(block, rows) ?? []);
  checkCount(header, blocks, log);
  reportDuplicates([...bones, ...morphs], log);
  if (blocks.length === 0) {
    const effect = 'the pose changes nothing';
    log.warn({ code: 'vpd/empty', expected: 'bones', found: 'none', effect });
  }
  return log.finish({ model: header.model, bones, morphs });
}

/** Returns the index of the line after the signature, or -1 if the file is of another kind. */
function readSignature(lines: readonly TextLine[], log: DiagnosticLog): number {
  const index = lines.findIndex(({ text }) => text.trim() !== '');
  const line = lines[index];
  if (line?.text.trim().toLowerCase().startsWith(signature.toLowerCase())) return index + 1;
  const found = line?.text.trim() ?? '';
  const hint = found.startsWith('Vocaloid Motion') ? ' (this is a motion file)' : '';
  log.error({
    code: 'vpd/magic',
    line: line?.line ?? 1,
    expected: `"${signature}"${hint}`,
    found,
    effect: 'the pose is not used',
  });
  return -1;
}

interface Header {
  readonly model: string;
  readonly count: number | undefined;
  readonly countLine: TextLine | undefined;
  /** The index of the line after it. */
  readonly next: number;
}

/** Reads `MODEL.osm;` and `COUNT;`. */
function readHeader(lines: readonly TextLine[], start: number, log: DiagnosticLog): Header {
  let next = start;
  const take = (isExpected: (text: string) => boolean): TextLine | undefined => {
    const index = lines.findIndex((line, at) => at >= next && bareText(line) !== '');
    const line = lines[index];
    if (!line || blockHead.test(bareText(line)) || !isExpected(bareText(line))) return undefined;
    next = index + 1;
    return line;
  };
  const isCount = (text: string): boolean => /^[+-]?\d+\s*;?$/.test(text);
  const modelLine = take((text) => !isCount(text));
  if (!modelLine) reportMissing('the name of the model and ";"', 'it has none');
  const model = modelLine ? statement(modelLine, log) : '';
  const countLine = take(() => true);
  const counted = countLine ? statement(countLine, log) : '';
  const isWhole = /^\d{1,9}$/.test(counted);
  if (!countLine) reportMissing('the count of bones and ";"', 'they are counted');
  else if (!isWhole) {
    const { line, text: source } = countLine;
    const expected = 'the count of bones, a whole number';
    const effect = 'they are counted';
    log.warn({ code: 'vpd/integer', line, source, expected, found: counted, effect });
  }
  return { model, count: isWhole ? Number(counted) : undefined, countLine, next };

  function reportMissing(expected: string, effect: string): void {
    const { line, text: found } = lines[next] ?? lines.at(-1)!;
    log.warn({ code: 'vpd/missing', line, expected, found: found.trim(), effect });
  }
}

/** A line up to its semicolon, which is reported if it is missing. */
function statement(line: TextLine, log: DiagnosticLog): string {
  const text = bareText(line);
  const end = text.indexOf(';');
  if (end >= 0) return text.slice(0, end).trim();
  const { line: number, text: source } = line;
  const effect = 'read as if it were there';
  log.warn({ code: 'vpd/token', line: number, source, expected: '";"', found: 'none', effect });
  return text;
}

function readBlocks(lines: readonly TextLine[], start: number, log: DiagnosticLog): Block[] {
  const blocks: Block[] = [];
  let open: { head: TextLine; match: RegExpExecArray; rows: TextLine[] } | undefined;
  const close = (isClosed: boolean): void => {
    if (!open) return;
    const { head, match, rows } = open;
    const kind = match[1]!.toLowerCase() === 'bone' ? 'bone' : 'morph';
    blocks.push({ kind, name: match[2]!.trim(), head, rows, isClosed });
    open = undefined;
  };
  for (const line of lines.slice(start)) {
    const text = bareText(line);
    if (text === '') continue;
    const match = blockHead.exec(text);
    if (match) {
      close(false);
      open = { head: line, match, rows: [] };
    } else if (open) {
      const end = text.indexOf('}');
      if (end !== 0) open.rows.push(line);
      if (end >= 0) close(true);
    } else {
      const expected = 'a block such as "Bone0{NAME"';
      const effect = 'this line is left out';
      log.errorOfPart({ code: 'vpd/token', line: line.line, expected, found: text, effect });
    }
  }
  close(false);
  return blocks;
}

function boneOf(block: Block, rows: VpdRows): VpdBone | undefined {
  if (block.kind !== 'bone') return undefined;
  const read = valuesOf(
    block,
    [
      ['x, y, z', 3],
      ['x, y, z, w', 4],
    ],
    rows,
  );
  if (!read) return undefined;
  const [[px, py, pz], [x, y, z, w]] = read as [number[], number[]];
  return {
    name: block.name,
    line: block.head.line,
    position: [px!, py!, pz!],
    rotation: [x!, y!, z!, w!],
  };
}

function morphOf(block: Block, rows: VpdRows): VpdMorph | undefined {
  if (block.kind !== 'morph') return undefined;
  const read = valuesOf(block, [['a weight', 1]], rows);
  return read && { name: block.name, line: block.head.line, weight: read[0]![0]! };
}

/** The values of a block's rows, or nothing if it is damaged, which is reported. */
function valuesOf(
  { kind, name, head, rows: lines, isClosed }: Block,
  wanted: readonly (readonly [what: string, count: number])[],
  rows: VpdRows,
): number[][] | undefined {
  if (name === '') {
    rows.report('vpd/name', head, `the name of a ${kind}`, 'none');
    return undefined;
  }
  const values: number[][] = [];
  for (const [index, [what, count]] of wanted.entries()) {
    const line = lines[index];
    if (!line) {
      const found = isClosed ? '"}"' : 'the end of its lines';
      rows.report(isClosed ? 'vpd/field-count' : 'vpd/end', head, `${what} of "${name}"`, found);
      return undefined;
    }
    const read = rows.numbers(line, count, `${what} of "${name}"`);
    if (!read) return undefined;
    values.push(read);
  }
  const more = lines[wanted.length];
  if (more)
    rows.warn('vpd/trailing', more, `"}" after ${wanted.at(-1)![0]} of "${name}"`, bareText(more));
  else if (!isClosed) rows.warn('vpd/end', head, `"}" after the values of "${name}"`, 'none');
  return values;
}

function checkCount(
  { count, countLine }: Header,
  blocks: readonly Block[],
  log: DiagnosticLog,
): void {
  const found = blocks.filter(({ kind }) => kind === 'bone').length;
  if (count === undefined || count === found || !countLine) return;
  const { line, text: source } = countLine;
  const effect = 'those that are there are used';
  log.warn({
    code: 'vpd/count',
    line,
    source,
    expected: `${count} bones`,
    found: `${found}`,
    effect,
  });
}

function reportDuplicates(all: readonly (VpdBone | VpdMorph)[], log: DiagnosticLog): void {
  const seen = new Set<string>();
  for (const { name, line, ...values } of all) {
    const key = `${'weight' in values ? 'morph' : 'bone'} ${name}`;
    if (seen.has(key)) {
      const effect = 'the last one is used';
      log.warn({ code: 'vpd/duplicate', line, expected: 'each name once', found: name, effect });
    }
    seen.add(key);
  }
}
