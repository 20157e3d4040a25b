import type { CharacterParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { BinaryReader } from '../binary/binary-reader.ts';
import { meshParts, skeletonParts, skinParts } from './assemble.ts';
import { type PmdBone, readBones } from './bones.ts';
import { readExtras } from './extras.ts';
import { readFaces } from './faces.ts';
import { readHeader } from './header.ts';
import { readIkChains } from './ik.ts';
import { readMaterials } from './materials.ts';
import type { MmdParts } from './mmd-parts.ts';
import { mmdShape } from './shape.ts';
import { rotationLinks } from './rotation-links.ts';
import { readSignature } from './signature.ts';
import { type PmdVertices, readVertices } from './vertices.ts';

const effect = 'the file is not used';
const codes = { truncated: 'pmd/truncated', count: 'pmd/count' } as const;

/** All parts of a PMD; the name of the character is that of its file. */
export type PmdParts = Omit<CharacterParts, 'name' | 'missing'>;

/**
 * Reads a PMD (MikuMikuDance's "Polygon Model Data", version 1.0, whose layout is documented only
 * by programs that read it), section by section to its end, and converts it from its left-handed
 * space to Sinew's. Files with only bones or only a mesh are read too. An invalid section after the
 * IK chains invalidates only itself and the sections after it.
 */
export function readPmd(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<PmdParts> {
  const log = new DiagnosticLog(file);
  const reader = new BinaryReader(bytes, log, codes, effect);
  return log.finish(readParts());

  function readParts(): PmdParts | undefined {
    if (!readSignature(reader, bytes, log, effect)) return undefined;
    const header = readHeader(reader, log, effect);
    const vertices = header && readVertices(reader, log, limits, effect);
    const faces = vertices && readFaces(reader, vertices.count, log, limits, effect);
    const materials = faces && readMaterials(reader, faces.length, log, effect);
    const bones = materials && readBones(reader, limits.coordinate, log, effect);
    const ikChains = bones && readIkChains(reader, bones.length, log);
    if (!ikChains || !hasContent(vertices, bones)) return undefined;
    const extras = readExtras(reader, file, vertices.count, bones.length, log, limits);
    const isSkinned = vertices.count > 0 && bones.length > 0;
    const extra: MmdParts = {
      kind: 'mmd',
      summary: 'IK chains, lists, physics and names in English',
      ...header,
      bones: bones.map(({ type, tail, ikParent, head }) => ({ type, tail, ikParent, head })),
      vertices: {
        normals: vertices.normals,
        uvs: vertices.uvs,
        bones: vertices.bones,
        weights: vertices.weights,
        edgeFlags: vertices.edgeFlags,
      },
      ikChains,
      ...extras.mmd,
    };
    return {
      fileSpace: mmdShape.handedness,
      ...(bones.length > 0
        ? { skeleton: skeletonParts(file, bones, extras.mmd.english?.boneNames) }
        : {}),
      ...(vertices.count > 0 ? { mesh: meshParts(file, vertices, faces, materials) } : {}),
      ...(isSkinned ? { skin: skinParts(file, vertices, bones.length, log, effect) } : {}),
      morphs: extras.morphs,
      // Toons shade a surface and may be missing, because every program for these files has its
      // own.
      optionalImages: extras.mmd.toons,
      rotationLinks: rotationLinks(bones),
      ikChains,
      extra,
    };
  }

  function hasContent(vertices: PmdVertices, bones: readonly PmdBone[]): boolean {
    if (vertices.count > 0) return true;
    const { offset } = vertices;
    const expected = 'vertices';
    if (bones.length === 0) {
      log.error({
        code: 'pmd/empty',
        offset,
        expected: 'vertices or bones',
        found: 'none',
        effect,
      });
      return false;
    }
    log.warn({ code: 'pmd/empty', offset, expected, found: 'none', effect: 'its bones are shown' });
    return true;
  }
}
