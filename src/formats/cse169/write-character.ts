import type { Character } from '../../core/character.ts';
import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { Diagnostic } from '../../core/diagnostics.ts';
import { noJoint } from '../../core/skin.ts';
import type { OutputFile, Written } from '../format.ts';
import { lost } from '../lost.ts';
import { writeAnimOf } from './anim-of-clip.ts';
import { writeMorph } from './write-morph.ts';
import { writeSkel, writtenNames } from './write-skel.ts';
import { writeSkin } from './write-skin.ts';

/**
 * Writes a file for each part that exists. The skeleton must rotate like this format, by Rz·Ry·Rx
 * without rest rotations; `convertCharacter` converts any other skeleton.
 */
export function writeCse169(
  character: Character,
  clips: readonly ClipParts[] = character.clips,
): Written {
  const { name, skeleton, mesh, morphs } = character;
  const files: OutputFile[] = [];
  if (skeleton.jointCount > 0) files.push({ path: `${name}.skel`, bytes: writeSkel(skeleton) });
  if (mesh.pointCount > 0) {
    files.push({ path: `${name}.skin`, bytes: writeSkin(character) });
    for (const morph of morphs) {
      files.push({ path: `${morph.name}.morph`, bytes: writeMorph(morph, mesh) });
    }
  }
  const motions = clips.map((clip) => writeAnimOf(clip, skeleton, skeleton.qRest));
  files.push(...motions.flatMap((motion) => motion.files));
  const ofMotions = motions.flatMap((motion) => motion.losses);
  return { files, losses: [...losses(character), ...ofMotions] };
}

function losses(character: Character): Diagnostic[] {
  const { name, skeleton, mesh, skin } = character;
  const found: Diagnostic[] = [];
  const written = writtenNames(skeleton);
  const renamed = written.filter((word, joint) => {
    return word !== skeleton.fileNames[joint] && word !== skeleton.names[joint];
  });
  if (renamed.length > 0) {
    found.push(
      lost(`${name}.skel`, 'names of one word', `${renamed.length} of several`, '_ joins them'),
    );
  }
  const splitCount = mesh.vertexCount - mesh.pointCount;
  if (splitCount > 0) {
    const effect = 'they are vertices of their own, behind the others';
    found.push(
      lost(`${name}.skin`, 'one normal and texcoord a vertex', `${splitCount} more`, effect),
    );
  }
  const used = new Set(mesh.submeshes.map(({ material }) => material));
  if (used.size > 1) {
    const effect = 'the last one is written for all triangles';
    found.push(lost(`${name}.skin`, 'one material', `${used.size}`, effect));
  }
  const entryCount = skin.paletteJoint.filter((joint) => joint !== noJoint).length;
  if (entryCount > skeleton.jointCount) {
    const effect = 'the first of each joint is written';
    found.push(lost(`${name}.skin`, 'one binding a joint', `${entryCount}`, effect));
  }
  return found;
}
