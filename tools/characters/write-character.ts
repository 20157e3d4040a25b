import { join } from 'node:path';
import { writeGzipText } from './gzip-file.ts';
import { attachText, objText, mtlText, skelText, type Material, type ObjMesh } from './mit-text.ts';
import { subtract, type Vector3 } from './vector.ts';

interface CharacterText {
  /** The positions of the joints in meters, in file order. */
  readonly joints: readonly Vector3[];
  /** Parents come before their children; -1 for the root. */
  readonly parents: readonly number[];
  readonly obj: ObjMesh;
  /** A row of `roundWeights` for each vertex, without a column for joint 0. */
  readonly rows: readonly (readonly number[])[];
  readonly materials?: readonly Material[];
}

/** Writes `NAME/NAME.skel.gz`, `.obj.gz`, `.mtl.gz` and `.attach.gz` and prints their sizes. */
export function writeCharacter(dataFolder: string, name: string, text: CharacterText): void {
  const { joints, parents, obj, rows, materials } = text;
  const offsets = joints.map((joint, index) => {
    const parent = parents[index]!;
    return parent < 0 ? joint : subtract(joint, joints[parent]!);
  });
  const write = (ending: string, content: string): void => {
    const path = join(dataFolder, name, `${name}.${ending}.gz`);
    console.log(`${name}.${ending}.gz: ${writeGzipText(path, content)} bytes`);
  };
  write('skel', skelText(offsets, parents));
  write('obj', objText(obj, materials && `${name}.mtl`));
  if (materials) write('mtl', mtlText(materials));
  write('attach', attachText(rows));
}
