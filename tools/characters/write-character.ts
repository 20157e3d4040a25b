import { join } from 'node:path';
import { writeGzip } from './gzip-file.ts';
import { attachText, mtlText, roundWeights, skelText, type Material } from './mit-text.ts';
import { packMesh, type SourceMesh } from './pack-mesh.ts';
import { subtract, type Vector3 } from './vector.ts';

interface CharacterText {
  /** The positions of the joints in meters, in file order. */
  readonly joints: readonly Vector3[];
  /** Parents come before their children; -1 for the root. */
  readonly parents: readonly number[];
  /** The mesh; the character's materials are in `NAME.mtl`. */
  readonly mesh: SourceMesh;
  /** The weights of a vertex of the mesh, without joint 0. */
  readonly weightsOf: (vertex: number) => readonly number[];
  readonly materials?: readonly Material[];
}

/** Writes `NAME/NAME.skel.gz`, `.obj.gz`, `.mtl.gz` and `.attach.gz` and prints their sizes. */
export function writeCharacter(dataFolder: string, name: string, text: CharacterText): void {
  const { joints, parents, mesh, weightsOf, materials } = text;
  const offsets = joints.map((joint, index) => {
    const parent = parents[index]!;
    return parent < 0 ? joint : subtract(joint, joints[parent]!);
  });
  const write = (ending: string, content: string): void => {
    const path = join(dataFolder, name, `${name}.${ending}.gz`);
    console.log(`${name}.${ending}.gz: ${writeGzip(path, content)} bytes`);
  };
  write('skel', skelText(offsets, parents));
  const { text: obj, sourceVertex } = packMesh(mesh, materials && `${name}.mtl`);
  write('obj', obj);
  if (materials) write('mtl', mtlText(materials));
  write('attach', attachText(sourceVertex.map((vertex) => roundWeights(weightsOf(vertex)))));
}
