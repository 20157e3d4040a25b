import {
  type ClipParts,
  type ChannelTarget,
  isRotationChannel,
  type Quaternion,
  type RotationTarget,
} from '../core/motion/clip-parts.ts';
import { pinValues } from '../core/motion/targets.ts';
import { axisDofs, jointOfValue } from '../core/pose.ts';
import { DofKind, type Skeleton } from '../core/skeleton.ts';
import type { Pin } from '../posing/pins/pin.ts';
import { rotationOf } from './animated.ts';
import { jointTurn } from './joint-turn.ts';

/** What is shown of a character, from which keys are set. */
export interface ShownState {
  /** (qCount) */
  readonly q: Float64Array;
  /** (morphCount) */
  readonly morphWeights: Float64Array;
  readonly pins: readonly Pin[];
}

/** Values of a character by their kinds. */
export interface KeyedThings {
  /** Indices of q. */
  readonly values: readonly number[];
  /** Indices of morphs. */
  readonly morphs: readonly number[];
  /** Pinned joints. */
  readonly pins: readonly number[];
}

/** A target, the value that a key of it gets, and the indices of q that the key sets. */
export interface NewKey {
  readonly target: ChannelTarget;
  readonly value: number | Quaternion;
  readonly indices: readonly number[];
}

/**
 * Returns the keys that hold values as they are shown: one for each slide, hinge and morph, one for
 * each ball and for the hinges of a joint whose rotation the clip has a curve of, and four for each
 * pin. Values that no curve can move have none.
 */
export function keysOf(
  skeleton: Skeleton,
  clip: ClipParts,
  shown: ShownState,
  { values, morphs, pins }: KeyedThings,
): readonly NewKey[] {
  const turned = new Map(
    clip.channels.filter(isRotationChannel).map(({ target }) => [target.joint, target]),
  );
  const found = new Map<string, NewKey>();
  for (const index of values) {
    const key = keyOfValue(skeleton, turned, shown.q, index);
    if (key) found.set(key.indices.join(), key);
  }
  const ofMorphs = morphs.map((morph): NewKey => {
    const value = shown.morphWeights[morph]!;
    return { target: { of: 'morph', morph }, value, indices: [] };
  });
  const ofPins = shown.pins
    .filter(({ joint }) => pins.includes(joint))
    .flatMap((pin) => keysOfPin(skeleton, pin));
  return [...found.values(), ...ofMorphs, ...ofPins];
}

/** @param turned the targets of the clip's curves of rotations, by the joint's index in its file */
function keyOfValue(
  skeleton: Skeleton,
  turned: ReadonlyMap<number, RotationTarget>,
  q: Float64Array,
  index: number,
): NewKey | null {
  const joint = jointOfValue(skeleton, index);
  const source = skeleton.sourceIndex[joint]!;
  const own = axisDofs(skeleton, joint).find((dof) => dof.index === index);
  const rotation = rotationOf(skeleton, joint);
  const isTurn = rotation.includes(index);
  if (isTurn && (turned.has(source) || isBall(skeleton, joint))) {
    const target = turned.get(source) ?? { of: 'rotation', joint: source, curve: 'squad' };
    return { target, value: jointTurn(skeleton, q, joint), indices: rotation };
  }
  if (!own) return null;
  const { kind, axis } = own;
  const target = { of: 'value', joint: source, kind, axis } as const;
  return { target, value: q[index]!, indices: [index] };
}

function isBall({ dofStart, dofKind }: Skeleton, joint: number): boolean {
  return dofKind.subarray(dofStart[joint], dofStart[joint + 1]).includes(DofKind.ball);
}

function keysOfPin({ sourceIndex }: Skeleton, { joint, place, weight }: Pin): readonly NewKey[] {
  return pinValues.map((value, at): NewKey => {
    const target = { of: 'pin', joint: sourceIndex[joint]!, value } as const;
    return { target, value: at < 3 ? place[at]! : weight, indices: [] };
  });
}
