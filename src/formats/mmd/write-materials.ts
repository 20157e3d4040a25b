import type { MaterialColors, MaterialParts } from '../../core/character-parts.ts';
import type { BinaryWriter } from '../binary/binary-writer.ts';
import { encodeName } from './encode-name.ts';
import type { MaterialRun } from './material-runs.ts';
import { textureField, textureFieldSize } from './texture-field.ts';

type WrittenColors = Omit<MaterialColors, 'shown'>;

/** A material without colors is written as light clay; with an image, as white. */
const clay = mattePaint([0.74, 0.72, 0.7], [0.37, 0.36, 0.35]);
const white = mattePaint([1, 1, 1], [0.5, 0.5, 0.5]);

const noToon = 255;
/** Shades materials of other formats, which have no toons. */
const firstToon = 0;

/** Writes the materials, each with the number of its corners. */
export function writeMaterials(out: BinaryWriter, runs: readonly MaterialRun[]): void {
  out.u32(runs.length);
  for (const { material, corners } of runs) {
    const { diffuse, alpha, shininess, specular, ambient } = paintOf(material);
    out.f32(...diffuse, alpha, shininess, ...specular, ...ambient);
    const { toon = firstToon, hasEdge = false } = material;
    out.u8(toon === -1 ? noToon : toon, Number(hasEdge));
    out.u32(corners.length);
    out.bytes(encodeName(textureField(material) ?? '', textureFieldSize));
  }
}

function paintOf({ colors, texture }: MaterialParts): WrittenColors {
  return colors ?? (texture === undefined ? clay : white);
}

function mattePaint(
  diffuse: WrittenColors['diffuse'],
  ambient: WrittenColors['ambient'],
): WrittenColors {
  return { diffuse, alpha: 1, shininess: 5, specular: [0, 0, 0], ambient };
}
