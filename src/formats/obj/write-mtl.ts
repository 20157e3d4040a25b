import type { MaterialParts } from '../../core/character-parts.ts';
import { encodeLines, writeFloat64 } from '../text/write-number.ts';
import { materialText } from './material-text.ts';

/** Writes materials as a material library, with their colors and textures. */
export function writeMtl(materials: readonly MaterialParts[]): Uint8Array {
  const lines: string[] = [];
  for (const { name, colors, texture } of materials) {
    lines.push(`newmtl ${materialText(name)}`.trimEnd());
    if (colors) {
      const { diffuse, specular, ambient, shininess, alpha } = colors;
      for (const [keyword, numbers] of [
        ['Kd', diffuse],
        ['Ks', specular],
        ['Ka', ambient],
        ['Ns', [shininess]],
        ['d', [alpha]],
      ] as const) {
        lines.push(`${keyword} ${numbers.map(writeFloat64).join(' ')}`);
      }
    }
    if (texture !== undefined) lines.push(`map_Kd ${materialText(texture)}`);
  }
  return encodeLines(lines);
}
