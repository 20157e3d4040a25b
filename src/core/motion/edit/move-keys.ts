import type { ClipParts, KeyParts, RotationKeyParts } from '../clip-parts.ts';
import type { KeySelection } from '../key-selection.ts';
import { isScalarKey } from './keys.ts';
import { placeKeys } from './place-keys.ts';
import { stretchedTangents } from './stretch.ts';
import type { EditedKeys } from './selection.ts';

/**
 * Moves keys by a time, and by a value those that are of one number. A key that comes to the time
 * of one that is not selected replaces it.
 */
export function moveKeys(
  clip: ClipParts,
  selection: KeySelection,
  { seconds, value = 0 }: { readonly seconds: number; readonly value?: number },
): EditedKeys {
  if (seconds === 0 && value === 0) return { clip, selection };
  return placeKeys(clip, selection, (key) => {
    const time = key.time + seconds;
    return isScalarKey(key) ? { ...key, time, value: key.value + value } : { ...key, time };
  });
}

/** Factors of distances from a time and from a value. */
export interface KeyScale {
  readonly aboutTime: number;
  /** Negative to reverse; 0 puts all keys at one time, where the last one stays. */
  readonly timeFactor: number;
  readonly aboutValue?: number;
  /** Of keys of one number. */
  readonly valueFactor?: number;
}

/**
 * Scales keys about a time and a value, and their fixed slopes with them, so that a whole curve
 * keeps its shape. Reversed, the tangents of each key change sides.
 */
export function scaleKeys(
  clip: ClipParts,
  selection: KeySelection,
  { aboutTime, timeFactor, aboutValue = 0, valueFactor = 1 }: KeyScale,
): EditedKeys {
  if (timeFactor === 1 && valueFactor === 1) return { clip, selection };
  const scaled = (key: KeyParts | RotationKeyParts): KeyParts | RotationKeyParts => {
    const time = aboutTime + (key.time - aboutTime) * timeFactor;
    if (!isScalarKey(key)) return { ...key, time };
    const value = aboutValue + (key.value - aboutValue) * valueFactor;
    return { time, value, ...stretchedTangents(key, timeFactor, valueFactor) };
  };
  return placeKeys(clip, selection, scaled);
}
