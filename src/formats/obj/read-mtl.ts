import type { Color, MaterialParts } from '../../core/character-parts.ts';
import type { Parsed } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { decodeText } from '../text/decode-text.ts';
import { finishMaterial, type MaterialLines } from './material-lines.ts';

/**
 * Reads a material library of Wavefront OBJ: `newmtl` with `Kd`, `Ks`, `Ns`, `Ka`, `d` or `Tr`, and
 * `map_Kd`. A material without `Kd` has no color of its own. A library of only plain lines, as that
 * of the first picture, does not need the code for the others.
 */
export async function readMtl(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Promise<Parsed<readonly MaterialParts[]>> {
  const plain = readPlainMtl(decodeText(bytes));
  if (plain) return { value: plain.map(finishMaterial), diagnostics: [] };
  const { readCarefulMtl } = await loadPart(import('./careful-mtl.ts'));
  return readCarefulMtl(file, bytes, limits);
}

const plainLine = /^(newmtl|Kd|Ks|Ns) ([a-z][a-z ]*[a-z]|\d?\.?\d+( \d?\.?\d+){2}|\d{1,3})$/;

/** Returns nothing if a line is not plain: lower-case words, colors of three numbers, exponents. */
function readPlainMtl(text: string): MaterialLines[] | undefined {
  const materials: MaterialLines[] = [];
  for (const line of text.trimEnd().split('\n')) {
    const [, keyword, words = ''] = plainLine.exec(line) ?? [];
    const numbers = words.split(' ').map(Number);
    const material = materials.at(-1);
    const isColor = numbers.length === 3 && !Number.isNaN(numbers[0]);
    if (keyword === 'newmtl' && Number.isNaN(numbers[0])) materials.push({ name: words });
    else if (!material) return undefined;
    else if (keyword === 'Ns' && numbers.length === 1) material.shininess = numbers[0]!;
    else if (keyword === 'Kd' && isColor) material.diffuse = numbers as unknown as Color;
    else if (keyword === 'Ks' && isColor) material.specular = numbers as unknown as Color;
    else return undefined;
  }
  return materials;
}
