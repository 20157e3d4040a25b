import type { Character } from '../../core/character.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import { noJoint } from '../../core/skin.ts';
import { uniqueNames } from '../unique-names.ts';
import type { BonePairs } from './bone-pairs.ts';
import type { MaterialRun } from './material-runs.ts';
import { textureField } from './texture-field.ts';

/** Reports what a PMD can't hold of a character from another format. */
export function reportForeignParts(
  { mesh, skin, skeleton, morphs, extra }: Character,
  { changedCount, largestChange }: BonePairs,
  log: DiagnosticLog,
): void {
  if (extra) lose(log, 'data that fit the joints and vertices', extra.summary, 'left out');
  if (changedCount > 0) {
    const found = `others, for ${changedCount} vertices`;
    const effect = `they are rounded; a weight changes by at most ${Number(largestChange.toPrecision(2))}`;
    lose(log, 'weights in hundredths that sum to 1', found, effect);
  }
  if (skeleton.jointCount > 0 && mesh.pointCount > 0 && skin.paletteJoint.includes(noJoint)) {
    lose(log, 'weights for each vertex', 'none', 'all vertices follow the first bone');
  }
  const withNormals = morphs.filter(({ normalVertices }) => normalVertices.length > 0);
  if (withNormals.length > 0) {
    lose(log, 'morphs without normals', `normals of ${withNormals.length}`, 'left out');
  }
}

/** Reports names of materials, which the file does not have, and of images without room in it. */
export function reportMaterials(runs: readonly MaterialRun[], log: DiagnosticLog): void {
  const numbered = uniqueNames(
    runs.map(() => ''),
    'material',
  );
  const named = runs.filter(({ material: { name } }, index) => {
    return name !== '' && name !== numbered[index];
  });
  if (named.length > 0) {
    lose(log, 'materials without names', `names of ${named.length}`, 'they are numbered');
  }
  const withoutImage = runs.filter(({ material }) => textureField(material) === undefined);
  if (withoutImage.length > 0) {
    const found = `others, for ${withoutImage.length} materials`;
    lose(log, 'names of images of at most 20 bytes in Shift-JIS', found, 'left out');
  }
}

/** Reports names that are written in another form. */
export function reportNames(
  names: readonly string[],
  written: readonly string[],
  log: DiagnosticLog,
): void {
  const changed = names.filter((name, index) => name !== written[index]);
  if (changed.length === 0) return;
  const effect = 'they are cut, with ? for characters that Shift-JIS does not have';
  const found = `${changed.length} others, such as ${changed[0]!}`;
  lose(log, 'names of at most 20 bytes in Shift-JIS', found, effect);
}

function lose(log: DiagnosticLog, expected: string, found: string, effect: string): void {
  log.warn({ code: 'pmd/lost', expected, found, effect });
}
