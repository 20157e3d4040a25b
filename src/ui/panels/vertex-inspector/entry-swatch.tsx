import { noJoint } from '../../../core/skin.ts';
import type { Actor } from '../../../document/scene.ts';
import { jointColorsOf } from '../../../skinning/weights/joint-colors.ts';
import { cssColor } from '../../css-color.ts';

interface EntrySwatchProperties {
  readonly actor: Actor;
  readonly entry: number;
}

/** The color of a palette entry's joint, as in the view. */
export function EntrySwatch({ actor: { character }, entry }: EntrySwatchProperties) {
  const joint = character.skin.paletteJoint[entry]!;
  const { bytes } = jointColorsOf(character.skeleton);
  const background = joint === noJoint ? 'transparent' : cssColor(bytes.subarray(joint * 3));
  return <span class="swatch" aria-hidden="true" style={{ background }} />;
}
