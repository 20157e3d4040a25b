import type { MaterialParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { assembleSkin, effect, type Sections, type SkinFile } from './assemble-skin.ts';
import { readBindings } from './bindings.ts';
import { readMaterial } from './material.ts';
import { scan, type Scanner } from './scanner.ts';
import { OddValues } from './odd-values.ts';
import { readRows } from './sections.ts';
import { readSkinWeights } from './skin-weights.ts';
import { readTriangles } from './triangles.ts';

const keywords = new Set([
  ...['positions', 'normals', 'texcoords', 'skinweights', 'triangles', 'bindings', 'material'],
]);
const isKeyword = (word: string): boolean => keywords.has(word);

/**
 * Reads a `.skin` of CSE169 (project 2): vertices, weights, triangles and the binding matrix of
 * every joint, which is used whatever pose the skeleton has. The sections may be in any order.
 */
export function readSkin(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<SkinFile> {
  const log = new DiagnosticLog(file);
  const scanner = scan(file, bytes, log, { area: 'skin', effect }, limits);
  if (!scanner) return log.finish<SkinFile>(undefined);
  const sections: Sections = {};
  const materials: MaterialParts[] = [];
  while (scanner.sound()) {
    const word = scanner.keyword(isKeyword);
    if (scanner.reader.atEnd) break;
    if (word === 'material') {
      const material = readMaterial(scanner);
      if (material) materials.push(material);
    } else if (isKeyword(word)) readSection(scanner, word as keyof Sections, sections);
    else if (scanner.reader.isWord) scanner.skipUnknown(isKeyword);
    else scanner.fail('token', 'the name of a section');
  }
  scanner.checkEnd();
  return log.finish(scanner.sound() ? assembleSkin(file, log, sections, materials) : undefined);
}

function readSection(scanner: Scanner, word: keyof Sections, sections: Sections): void {
  const { limits } = scanner;
  if (sections[word]) {
    scanner.fail('duplicate', `one section "${word}"`, 'another');
    return;
  }
  const rows = (size: number) => readRows(scanner, word, size, limits.pointCount);
  const read = {
    positions: () => rows(3),
    normals: () => rows(3),
    texcoords: () => {
      const odd = new OddValues();
      const section = readRows(scanner, word, 2, limits.pointCount, odd);
      return odd.report(scanner, word) ? undefined : section;
    },
    skinweights: () => readSkinWeights(scanner, limits.pointCount, limits.jointCount),
    triangles: () => readTriangles(scanner, limits),
    bindings: () => readBindings(scanner, limits.jointCount),
  }[word]();
  if (read) Object.assign(sections, { [word]: read });
}
