import { noJoint, type Skin } from '../core/skin.ts';
import { flushSubnormal } from '../core/float32.ts';

/**
 * Packs the upper three rows of `characterFromJoint · jointFromBind` for every palette entry, row
 * by row (3 vec4s): the M = T · B⁻¹ of the 6.837 handout, part 4. Products are float64 and are
 * rounded once if the palette is float32.
 */
export function packAffinePalette(
  skin: Skin,
  characterFromJoint: Float64Array,
  palette: Float32Array,
): void {
  for (let entry = 0; entry < skin.paletteJoint.length; entry++) {
    writeAffineRows(skin, characterFromJoint, entry, palette, entry * 12);
  }
}

/** Writes the 12 numbers of one palette entry, starting at `at`. */
export function writeAffineRows(
  { paletteJoint, jointFromBind }: Skin,
  characterFromJoint: Float64Array,
  entry: number,
  out: Float32Array | Float64Array,
  at: number,
): void {
  const joint = paletteJoint[entry]!;
  const bind = entry * 16;
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 4; column++) {
      let sum: number;
      if (joint === noJoint) sum = jointFromBind[bind + column * 4 + row]!;
      else {
        sum = 0;
        for (let k = 0; k < 4; k++) {
          sum +=
            characterFromJoint[joint * 16 + k * 4 + row]! * jointFromBind[bind + column * 4 + k]!;
        }
      }
      out[at + row * 4 + column] = flushSubnormal(sum);
    }
  }
}
