import { clipFor, evaluateClip } from '../core/motion/clip.ts';
import { pinValues } from '../core/motion/targets.ts';
import type { Pin } from './pins/pin.ts';
import type { LayerFunction, PoseContext } from './pose-layer.ts';

/**
 * Sets the values that the bound clip animates, at its time, except those that were edited since;
 * other values keep their edited state.
 */
export const applyClip: LayerFunction = (context, pose) => {
  const { character, clip, time, unkeyed } = context;
  if (!clip) return;
  const compiled = clipFor(clip, character);
  const { curves } = compiled;
  const pins = curves.pins.length > 0 ? placesOf(context) : noPlaces;
  // Later stages keep the weights as an input, so that they are not written in place.
  if (curves.morphWeights.length > 0) pose.morphWeights = pose.morphWeights.slice();
  evaluateClip(compiled, time, { q: pose.q, morphWeights: pose.morphWeights, pins });
  for (const index of unkeyed?.values ?? []) pose.q[index] = context.q[index]!;
  if (curves.morphWeights.length > 0) {
    for (const index of unkeyed?.morphs ?? []) {
      pose.morphWeights[index] = context.morphWeights[index]!;
    }
  }
  if (pins.length > 0) pose.pins = pose.pins.map((pin) => placed(pin, pins, unkeyed?.pins ?? []));
};

const noPlaces = new Float64Array(0);

/** Returns (jointCount × 4) where the pins of the actor are held, and their weights. */
function placesOf({ character: { skeleton }, pins }: PoseContext): Float64Array {
  const places = new Float64Array(skeleton.jointCount * pinValues.length);
  for (const { joint, place, weight } of pins) places.set([...place, weight], joint * 4);
  return places;
}

function placed(pin: Pin, places: Float64Array, unkeyed: readonly number[]): Pin {
  if (unkeyed.includes(pin.joint)) return pin;
  const [x, y, z, weight] = places.subarray(pin.joint * 4);
  return { ...pin, place: [x!, y!, z!], weight: weight! };
}
