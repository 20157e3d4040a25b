import { type Bounds, emptyBounds, includePositions } from './bounds.ts';
import { boxCorners } from './display-boxes.ts';
import { buildLinks } from './build-links.ts';
import { buildMesh } from './build-mesh.ts';
import { buildSkeleton, emptySkeleton } from './build-skeleton.ts';
import { buildSkin, buildStaticSkin } from './build-skin.ts';
import type { CharacterParts, MeshParts, SkinParts } from './character-parts.ts';
import type { Character } from './character.ts';
import { reportCoincidentJoints } from './coincident-joints.ts';
import { type Diagnostic, DiagnosticLog, type Parsed } from './diagnostics.ts';
import { jointMatrices } from './forward-kinematics.ts';
import { defaultLimits, type Limits } from './limits.ts';
import { emptyMesh, type Mesh } from './mesh.ts';
import { buildMorph } from './morph.ts';
import type { Skeleton } from './skeleton.ts';
import type { Skin } from './skin.ts';

/**
 * Builds the characters of all formats: checks the loose parts against each other, sorts and packs
 * them, and reports problems. A part with an error is left out and the others are kept. The result
 * has a value if there is a skeleton or a mesh.
 */
export function buildCharacter(
  parts: CharacterParts,
  limits: Limits = defaultLimits,
): Parsed<Character> {
  const diagnostics: Diagnostic[] = [];
  const skeleton = buildPart(parts.skeleton, (part, log) => {
    const built = buildSkeleton(part, log, limits);
    if (built) reportCoincidentJoints(built, log);
    return built;
  });
  const mesh = parts.mesh ? buildMesh(parts.mesh) : emptyMesh;
  const skin = buildPart(parts.skin, (part, log) =>
    skinFits(part, parts.mesh, skeleton, log) ? buildSkin(part, skeleton!, log) : undefined,
  );
  if (!skeleton && !parts.mesh) return { diagnostics };
  return {
    value: assemble(parts, skeleton ?? emptySkeleton, mesh, skin),
    diagnostics,
  };

  function buildPart<P extends { readonly file: string }, T>(
    part: P | undefined,
    build: (part: P, log: DiagnosticLog) => T | undefined,
  ): T | undefined {
    if (!part) return undefined;
    const log = new DiagnosticLog(part.file);
    const { value, diagnostics: found } = log.finish(build(part, log));
    diagnostics.push(...found);
    return value;
  }
}

function assemble(
  parts: CharacterParts,
  skeleton: Skeleton,
  mesh: Mesh,
  skin: Skin = buildStaticSkin(mesh.pointCount),
): Character {
  return {
    name: parts.name,
    skeleton,
    mesh,
    skin,
    morphs: (parts.morphs ?? []).map((morph) => buildMorph(morph, mesh)),
    clips: parts.clips ?? [],
    materials: parts.mesh?.materials ?? [],
    images: [],
    bounds: restBounds(skeleton, mesh),
    missing: parts.missing,
    meta: { fileSpace: parts.fileSpace ?? 'right-handed' },
    optionalImages: parts.optionalImages ?? [],
    ...buildLinks(parts, skeleton),
    ...(parts.extra ? { extra: parts.extra } : {}),
  };
}

/**
 * Whether the numbers of rows and points agree. A skin without its mesh or skeleton is not used,
 * without a message.
 */
function skinFits(
  parts: SkinParts,
  mesh: MeshParts | undefined,
  skeleton: Skeleton | undefined,
  log: DiagnosticLog,
): boolean {
  if (!skeleton || skeleton.jointCount === 0 || !mesh) return false;
  const rowCount = parts.start.length - 1;
  const pointCount = mesh.positions.length / 3;
  if (rowCount === pointCount) return true;
  log.error({
    code: 'character/count',
    expected: `${pointCount} rows of weights, one for each vertex of ${mesh.file}`,
    found: `${rowCount} rows`,
    effect: 'the mesh is shown without its weights',
  });
  return false;
}

function restBounds(skeleton: Skeleton, mesh: Mesh): Bounds {
  const bounds = emptyBounds();
  includePositions(bounds, mesh.positions, mesh.vertexCount);
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    includePositions(bounds, characterFromJoint.subarray(joint * 16 + 12, joint * 16 + 15), 1);
  }
  if (mesh.pointCount === 0) {
    const corners = boxCorners(skeleton, characterFromJoint);
    includePositions(bounds, corners, corners.length / 3);
  }
  return bounds;
}
