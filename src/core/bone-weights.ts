import type { BoneFrame } from './bone-frames.ts';
import { noJoint, type Skin } from './skin.ts';

/** A sparse (bones × points) matrix, compressed by rows: a row a bone. */
export interface BoneWeights {
  /** (boneCount + 1) */
  readonly start: Uint32Array;
  /** (start[boneCount]) rising within a row. */
  readonly points: Uint32Array;
  /** (start[boneCount]) */
  readonly weights: Float64Array;
}

/**
 * The per-bone weights of UT CS354's handout, out of the weights by joint that files have. A joint's
 * weight is shared equally among the bones that start at it, which it turns; that of a joint without
 * child goes to the bone that ends at it, so that none is lost. A joint alone has no bone, and its
 * weight none. For looking at: skinning stays by joint.
 */
export function boneWeights(frames: readonly BoneFrame[], skin: Skin): BoneWeights {
  const outgoing = new Map<number, number[]>();
  const incoming = new Map<number, number[]>();
  frames.forEach(({ source, destination }, bone) => {
    const others = outgoing.get(source);
    if (others) others.push(bone);
    else outgoing.set(source, [bone]);
    incoming.set(destination, [bone]);
  });
  const rows = frames.map(() => new Map<number, number>());
  for (let point = 0; point + 1 < skin.start.length; point++) {
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const joint = skin.paletteJoint[skin.entries[i]!]!;
      const bones = joint === noJoint ? undefined : (outgoing.get(joint) ?? incoming.get(joint));
      for (const bone of bones ?? []) {
        const row = rows[bone]!;
        row.set(point, (row.get(point) ?? 0) + skin.weights[i]! / bones!.length);
      }
    }
  }
  const start = new Uint32Array(frames.length + 1);
  rows.forEach((row, bone) => (start[bone + 1] = start[bone]! + row.size));
  return {
    start,
    points: Uint32Array.from(rows.flatMap((row) => [...row.keys()])),
    weights: Float64Array.from(rows.flatMap((row) => [...row.values()])),
  };
}
