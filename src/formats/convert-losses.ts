import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { FormatShape } from './format.ts';
import { lost } from './lost.ts';

/**
 * Returns what a character has but files of the other shape can't hold, independent of its pose.
 * Values are solved again and points are renumbered, so limits, morphs and clips, which depend on
 * them, are left out of every conversion.
 */
export function partsLost(
  { name, skeleton, skin, morphs, clips, materials, extra }: Character,
  shape: FormatShape,
): Diagnostic[] {
  const losses: Diagnostic[] = [];
  const lose = (found: string, effect = 'left out'): void => {
    losses.push(lost(name, `what the files of ${shape.owner} can hold`, found, effect));
  };
  if (!shape.jointNames && skeleton.fileNames.some((each) => each !== '')) lose('names of joints');
  if (!shape.jointBoxes && skeleton.displayBoxes) lose('boxes of joints');
  if (!shape.bindings && skin.bindFromJoint && isTurned(skin.bindFromJoint)) {
    lose('rotations in the bindings', 'joints stand unturned where the mesh is bound');
  }
  if (!shape.restPose && skeleton.qRest.some((value) => value !== 0)) {
    lose("the file's pose", 'the mesh stands as it is bound; POSE.json holds the pose');
  }
  if (!shape.ownNormals && skin.bindFromJoint) lose('normals', 'computed from the triangles');
  if (!shape.textures && materials.some(({ texture }) => texture !== undefined)) {
    lose('names of textures');
  }
  if (!shape.colors && materials.some(({ colors }) => colors !== undefined))
    lose('colors of materials');
  if (extra) lose(extra.summary);
  const limited = skeleton.qMin.filter((low, i) => low > -Infinity || skeleton.qMax[i]! < Infinity);
  if (limited.length > 0) lose(`limits of ${limited.length} values`);
  if (morphs.length > 0) lose(`${morphs.length} morphs`);
  if (clips.length > 0) lose(`${clips.length} clips`);
  return losses;
}

/** Whether the linear part of any matrix differs from the identity. */
function isTurned(matrices: Float64Array): boolean {
  return matrices.some((value, i) => {
    const [row, column] = [i % 4, Math.floor((i % 16) / 4)];
    return row < 3 && column < 3 && value !== Number(row === column);
  });
}
