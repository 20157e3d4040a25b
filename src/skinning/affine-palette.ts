import { noJoint, type Skin } from '../core/skin.ts';
import { flushSubnormal } from '../core/float32.ts';

/**
 * Packs, for every palette entry, the upper three rows of `characterFromJoint · jointFromBind`, row by
 * row (3 vec4s): the M = T · B⁻¹ of the 6.837 handout, part 4. Products in
 * float64, rounded once where the palette is of float32.
 */
export function packAffinePalette(
  skin: Skin,
  characterFromJoint: Float64Array,
  palette: Float32Array | Float64Array,
): void {
  const { paletteJoint, jointFromBind } = skin;
  for (let entry = 0; entry < paletteJoint.length; entry++) {
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
        palette[entry * 12 + row * 4 + column] = flushSubnormal(sum);
      }
    }
  }
}
