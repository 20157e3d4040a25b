import type { Character } from '../../core/character.ts';
import type { JointNature } from '../ik/problem.ts';
import type { NatureSettings } from './nature-settings.ts';
import { naturesOf } from './natures.ts';

const none: readonly JointNature[] = [];

const known = new WeakMap<NatureSettings, Map<Character, readonly JointNature[]>>();

/**
 * Returns the natures that inverse kinematics keeps to: those that were found, with the user's own in
 * place of them, or none if they are switched off. Equal arguments give the same array.
 */
export function naturesInUse(
  character: Character,
  settings: NatureSettings,
): readonly JointNature[] {
  if (!settings.isOn) return none;
  const found = naturesOf(character);
  if (settings.own.length === 0) return found;
  let natures = known.get(settings)?.get(character);
  if (!natures) {
    natures = found.map((nature) => {
      const own = settings.own.find(({ joint }) => joint === nature.joint);
      return own ? { ...nature, ...own } : nature;
    });
    known.set(settings, new Map([[character, natures]]));
  }
  return natures;
}
