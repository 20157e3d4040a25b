import type { Character } from '../../core/character.ts';
import type { Diagnostic } from '../../core/diagnostics.ts';
import { noJoint } from '../../core/skin.ts';
import type { OutputFile, Written } from '../format.ts';
import { writeMtl } from '../obj/write-mtl.ts';
import { writeObj } from '../obj/write-obj.ts';
import { attachLosses } from './attach-losses.ts';
import { libraryExtension } from './kinds.ts';
import { objLosses } from './losses.ts';
import { skelLosses } from './skel-losses.ts';
import { writeAttach } from './write-attach.ts';
import { writeSkel } from './write-skel.ts';

/** Writes a file for each part that exists. */
export function writeMit({ name, skeleton, mesh, skin, materials }: Character): Written {
  const files: OutputFile[] = [];
  const losses: Diagnostic[] = [];
  if (skeleton.jointCount > 0) {
    const path = `${name}.skel`;
    files.push({ path, bytes: writeSkel(skeleton) });
    losses.push(...skelLosses(path, skeleton));
  }
  if (mesh.pointCount > 0) {
    const path = `${name}.obj`;
    const library = `${name}${libraryExtension}`;
    const isPlain = materials.length === 0;
    files.push({ path, bytes: writeObj(mesh, undefined, isPlain ? undefined : library) });
    if (!isPlain) files.push({ path: library, bytes: writeMtl(materials) });
    losses.push(...objLosses(path, mesh));
  }
  const followsJoints = !skin.paletteJoint.includes(noJoint);
  if (skeleton.jointCount > 0 && mesh.pointCount > 0 && followsJoints) {
    const path = `${name}.attach`;
    files.push({ path, bytes: writeAttach(skin, skeleton) });
    losses.push(...attachLosses(path, skin, skeleton));
  }
  return { files, losses };
}
