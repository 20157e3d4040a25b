import type { Character } from '../core/character.ts';
import type { Parsed } from '../core/diagnostics.ts';
import { pinOf } from '../document/open-clip.ts';
import type { KeptState } from '../document/scene.ts';
import { pinsToMake } from '../formats/motion/pins-to-make.ts';
import { readMotionFile } from './read-motion-file.ts';

/** Reads a motion as the bound clip of a character, with the pins that it moves. */
export async function motionOf(path: string, character: Character): Promise<Parsed<KeptState>> {
  const { value: clip, diagnostics, pinPlaces } = await readMotionFile(path, character);
  if (!clip) return { diagnostics };
  const made = pinsToMake(clip, character, [], pinPlaces);
  return {
    value: { clips: [clip], clip: 0, pins: made.pins.map(pinOf) },
    diagnostics: [...diagnostics, ...made.diagnostics],
  };
}
