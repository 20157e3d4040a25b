import type { Color, MaterialParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import type { LineReader } from '../text/line-reader.ts';
import { openText } from '../text/open-text.ts';
import { finishMaterial, type MaterialLines } from './material-lines.ts';

const effect = 'the line is left out';

/** Colors beyond this are damaged; programs write up to about 1. */
const largestColor = 1000;

/** Ignored without a message: the studio's surfaces have none of these properties. */
const silent = new Set([
  ...['illum', 'Ni', 'Ke', 'Tf', 'sharpness', 'Pr', 'Pm', 'Ps', 'Pc', 'Pcr', 'aniso', 'anisor'],
  ...['map_Ka', 'map_Ks', 'map_Ns', 'map_d', 'map_Ke', 'map_Bump', 'map_bump', 'bump', 'disp'],
  ...['decal', 'refl', 'norm', 'map_Pr', 'map_Pm', 'map_Ps', 'map_Kn', 'map_refl'],
]);

/** An option before the name of an image, with its words and numbers. */
const imageOption = /^-[a-z]+(\s+(on|off|[rgbmlz]|[-+]?\.?\d\S*)(?=\s))*\s+/i;

/** Reports that the current line is wrong. */
type Report = (expected: string) => void;

/** Reads any material library, and reports what is wrong with it. */
export function readCarefulMtl(
  file: string,
  bytes: Uint8Array,
  limits: Limits,
): Parsed<readonly MaterialParts[]> {
  const log = new DiagnosticLog(file);
  const reader = openText(file, bytes, log, { limits });
  if (!reader) return log.finish<readonly MaterialParts[]>(undefined);
  const drafts: MaterialLines[] = [];
  const unknown = new Set<string>();
  while (reader.next()) {
    if (!reader.token()) continue;
    const keyword = reader.text();
    const draft = drafts.at(-1);
    if (keyword === 'newmtl') drafts.push({ name: reader.rest() });
    else if (!draft) reportEarly(reader, log);
    else if (!readLine(keyword, draft, reader, log) && !silent.has(keyword)) {
      if (!unknown.has(keyword)) reportUnknown(reader, keyword, log);
      unknown.add(keyword);
    }
  }
  if (drafts.length === 0 && !log.failed) {
    const expected = 'at least one "newmtl"';
    log.warn({ code: 'mtl/empty', expected, found: 'none', effect: 'the file gives no color' });
  }
  return log.finish(drafts.map(finishMaterial));
}

/** Reads the rest of the line; returns false if the keyword is of no use here. */
function readLine(
  keyword: string,
  draft: MaterialLines,
  reader: LineReader,
  log: DiagnosticLog,
): boolean {
  const found = reader.rest();
  const report = (expected: string): void => {
    log.warn({ code: 'mtl/number', ...reader.linePlace, expected, found, effect });
  };
  switch (keyword) {
    case 'Kd':
      return set('diffuse', readColor(reader, report));
    case 'Ks':
      return set('specular', readColor(reader, report));
    case 'Ka':
      return set('ambient', readColor(reader, report));
    case 'Ns':
      return set('shininess', readNumber(reader, report, 'an exponent', [0, Infinity]));
    case 'd':
      return set('alpha', readNumber(reader, report, 'an opacity from 0 to 1', [0, 1]));
    case 'Tr': {
      const clear = readNumber(reader, report, 'a transparency from 0 to 1', [0, 1]);
      return set('alpha', clear === undefined ? undefined : 1 - clear);
    }
    case 'map_Kd':
      return set('texture', readImageName(found, report));
    default:
      return false;
  }

  function set<Key extends keyof MaterialLines>(
    key: Key,
    value: MaterialLines[Key] | undefined,
  ): true {
    if (value !== undefined) draft[key] = value;
    return true;
  }
}

function readColor(reader: LineReader, report: Report): Color | undefined {
  const channels: number[] = [];
  while (channels.length < 3 && reader.token()) channels.push(reader.number());
  // One number stands for all three.
  const [red = NaN, green = red, blue = red] = channels;
  const color: Color = [red, green, blue];
  const isColor = color.every((channel) => Math.abs(channel) <= largestColor);
  if (isColor) return color;
  report('three numbers for red, green and blue');
  return undefined;
}

function readNumber(
  reader: LineReader,
  report: Report,
  expected: string,
  [low, high]: readonly [number, number],
): number | undefined {
  const value = reader.token() ? reader.number() : NaN;
  if (value >= low && value <= high && value < Infinity) return value;
  report(expected);
  return undefined;
}

function readImageName(rest: string, report: Report): string | undefined {
  let name = rest;
  while (imageOption.test(name)) name = name.replace(imageOption, '');
  if (name !== '') return name;
  report('the name of an image');
  return undefined;
}

function reportEarly(reader: LineReader, log: DiagnosticLog): void {
  const expected = '"newmtl" before the properties of a material';
  log.warn({ code: 'mtl/token', ...reader.place, expected, found: reader.text(), effect });
}

function reportUnknown(reader: LineReader, keyword: string, log: DiagnosticLog): void {
  const expected = 'a property of a material';
  const leftOut = 'such lines are left out';
  log.warn({ code: 'mtl/unknown', ...reader.place, expected, found: keyword, effect: leftOut });
}
