import { type Diagnostic } from '../core/diagnostics.ts';
import { stemOf } from './belonging/draft.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { ReadCharacter } from './read-characters.ts';
import { formatOf, labelOf } from './registry.ts';

/**
 * Reports a skeleton of one format beside the mesh of another, which users take for one character:
 * both have the same name, or there are no other halves.
 */
export function reportHalves(characters: readonly ReadCharacter[]): Diagnostic[] {
  const skeletons = characters.filter(({ character: { skeleton, mesh } }) => {
    return skeleton.jointCount > 0 && mesh.pointCount === 0;
  });
  const meshes = characters.filter(({ character: { skeleton, mesh } }) => {
    return skeleton.jointCount === 0 && mesh.pointCount > 0;
  });
  const areAlone = skeletons.length === 1 && meshes.length === 1;
  return meshes.flatMap((mesh) => {
    const skeleton = skeletons.find((each) => areAlone || shareName(each, mesh));
    return skeleton ? reportPair(mesh, skeleton) : [];
  });
}

function shareName(a: ReadCharacter, b: ReadCharacter): boolean {
  return stemOf(a.files[0]!.path) === stemOf(b.files[0]!.path);
}

function reportPair(mesh: ReadCharacter, skeleton: ReadCharacter): Diagnostic[] {
  const [meshFile, skeletonFile] = [mesh.files[0]!, skeleton.files[0]!];
  const [wanted, given] = [formatOf(meshFile), formatOf(skeletonFile)];
  if (!wanted || !given || wanted === given) return [];
  const ending = extensionOf(skeletonFile.path);
  return [
    {
      severity: 'warning',
      code: 'file/pairing',
      file: baseName(meshFile.path),
      expected: `a ${ending} of ${labelOf(wanted)}`,
      found: `${baseName(skeletonFile.path)} of ${labelOf(given)}`,
      effect: 'they are shown as two characters',
    },
  ];
}
