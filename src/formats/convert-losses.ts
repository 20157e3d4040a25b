import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { ConvertTarget } from './convert-parts.ts';
import { lost } from './lost.ts';

/** What a character has and the other course's files have no place for, whatever its pose. */
export function partsLost(
  { name, skeleton, skin, morphs, clips, materials, extra }: Character,
  to: ConvertTarget,
): Diagnostic[] {
  const losses: Diagnostic[] = [];
  const course = to === 'mit' ? '6.837' : 'CSE169';
  const lose = (found: string, effect = 'left out'): void => {
    losses.push(lost(name, `what the files of ${course} can hold`, found, effect));
  };
  if (to === 'mit') {
    if (skeleton.fileNames.some((each) => each !== '')) lose('names of joints');
    if (skeleton.displayBoxes) lose('boxes of joints');
    if (skin.bindFromJoint && isTurned(skin.bindFromJoint)) {
      lose('rotations in the bindings', 'joints stand unturned where the mesh is bound');
    }
    if (skeleton.qRest.some((value) => value !== 0)) {
      lose("the file's pose", 'the mesh stands as it is bound; POSE.json holds the pose');
    }
    if (skin.bindFromJoint) lose('normals', 'computed from the triangles');
    if (materials.some(({ texture }) => texture !== undefined)) lose('names of textures');
  }
  if (materials.some(({ colors }) => colors !== undefined)) lose('colors of materials');
  if (extra) lose(extra.summary);
  const limited = skeleton.qMin.filter((low, i) => low > -Infinity || skeleton.qMax[i]! < Infinity);
  if (limited.length > 0) lose(`limits of ${limited.length} values`);
  if (morphs.length > 0) lose(`${morphs.length} morphs`);
  if (clips.length > 0) lose(`${clips.length} clips`);
  return losses;
}

/** Whether the linear part of any matrix is not the identity. */
function isTurned(matrices: Float64Array): boolean {
  return matrices.some((value, i) => {
    const [row, column] = [i % 4, Math.floor((i % 16) / 4)];
    return row < 3 && column < 3 && value !== Number(row === column);
  });
}
