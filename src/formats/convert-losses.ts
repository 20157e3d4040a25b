import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { FormatShape } from './format.ts';
import { lost } from './lost.ts';
import { influencesLost } from './influences-lost.ts';
import { writtenNames } from './written-names.ts';

/**
 * Returns what a character has but files of the other shape can't hold, independent of its pose.
 * Values are solved again, so limits and clips, which depend on them, are left out of every
 * conversion.
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
  const changed = changedNames(skeleton.names, shape);
  if (changed > 0) lose(`${changed} names of joints`, 'they are cut and written in Shift-JIS');
  if (!shape.jointBoxes && skeleton.displayBoxes) lose('boxes of joints');
  if (!shape.bindings && skin.bindFromJoint && isTurned(skin.bindFromJoint)) {
    lose('rotations in the bindings', 'joints stand unturned where the mesh is bound');
  }
  const { pointCount, largestShare } = influencesLost(skin, shape.influences);
  if (pointCount > 0) {
    const share = `up to ${Number((100 * largestShare).toPrecision(2))} % of its weights are left out`;
    lose(
      `${pointCount} vertices of over ${shape.influences} influences`,
      `each keeps its largest weights, divided by their sum; ${share}`,
    );
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
  if (!shape.morphs && morphs.length > 0) lose(`${morphs.length} morphs`);
  if (clips.length > 0) lose(`${clips.length} clips`);
  return losses;
}

function changedNames(names: readonly string[], { jointNames }: FormatShape): number {
  if (jointNames !== 'fields') return 0;
  const written = writtenNames(names, jointNames);
  return names.filter((name, index) => name !== written[index]).length;
}

/** Whether the linear part of any matrix differs from the identity. */
function isTurned(matrices: Float64Array): boolean {
  return matrices.some((value, i) => {
    const [row, column] = [i % 4, Math.floor((i % 16) / 4)];
    return row < 3 && column < 3 && value !== Number(row === column);
  });
}
