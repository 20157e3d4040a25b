import type { MaterialParts, MeshParts, SkinParts } from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Bindings } from './bindings.ts';
import type { Section } from './sections.ts';
import { cse169Shape } from './shape.ts';
import type { SkinWeights } from './skin-weights.ts';
import type { Triangles } from './triangles.ts';

export const effect = 'the mesh is not used';

/** The sections of a `.skin` that exist in the file. */
export interface Sections {
  positions?: Section;
  normals?: Section;
  texcoords?: Section;
  skinweights?: SkinWeights;
  triangles?: Triangles;
  bindings?: Bindings;
}

/**
 * The content of a `.skin`: a mesh and, if the file has them, weights with the bindings of their
 * joints.
 */
export interface SkinFile {
  readonly mesh: MeshParts;
  readonly skin?: SkinParts;
}

/** Checks the sections against each other; an error in one of them invalidates the whole file. */
export function assembleSkin(
  file: string,
  log: DiagnosticLog,
  sections: Sections,
  materials: readonly MaterialParts[],
): SkinFile | undefined {
  const { positions, triangles, normals, texcoords } = sections;
  checkPresent(log, 'positions', positions?.count);
  checkPresent(log, 'triangles', triangles?.lines.length);
  if (!positions || !triangles || log.failed) return undefined;
  const pointCount = positions.count;
  checkTriangles(log, triangles, pointCount);
  checkNormals(log, normals, pointCount);
  const uvs = uvsThatFit(log, texcoords, pointCount);
  const skin = weightsOf(file, log, sections, pointCount);
  const corners = new Int32Array(triangles.corners);
  const mesh: MeshParts = {
    file,
    positions: positions.values,
    cornerPoints: triangles.corners,
    ...(normals ? { normals: normals.values, cornerNormals: corners } : {}),
    ...(uvs ? { uvs: uvs.values, cornerUvs: corners } : {}),
    materials,
    submeshes: [{ material: materials.at(-1)?.name ?? '', firstTriangle: 0 }],
  };
  return { mesh, ...(skin ? { skin } : {}) };
}

function checkPresent(log: DiagnosticLog, name: string, count: number | undefined): void {
  const expected = `a section "${name}"`;
  if (count === undefined) log.error({ code: 'skin/section', expected, found: 'none', effect });
  else if (count === 0) {
    log.error({ code: 'skin/empty', expected: `at least one of "${name}"`, found: '0', effect });
  }
}

function weightsOf(
  file: string,
  log: DiagnosticLog,
  { skinweights, bindings }: Sections,
  pointCount: number,
): SkinParts | undefined {
  if (!skinweights || !bindings) {
    log.warn({
      code: 'skin/section',
      expected: '"skinweights" and "bindings"',
      found: skinweights ? 'no bindings' : 'no skinweights',
      effect: 'the mesh is shown undeformed',
    });
    return undefined;
  }
  const rowCount = skinweights.start.length - 1;
  if (rowCount !== pointCount) {
    const expected = `${pointCount} rows of skinweights, one for each position`;
    log.error({ code: 'skin/count', expected, found: `${rowCount}`, effect });
  }
  const { joints, start } = skinweights;
  const at = joints.findIndex((joint) => joint >= bindings.count);
  if (at >= 0) {
    const point = start.findIndex((first) => first > at) - 1;
    log.error({
      code: 'skin/index',
      line: skinweights.lines[point]!,
      expected:
        bindings.count > 0
          ? `joints from 0 to ${bindings.count - 1}, for which there are bindings`
          : 'no joint, for there are no bindings',
      found: `${joints[at]!}, vertex ${point}`,
      effect,
    });
  }
  const { jointFromBind, bindFromJoint } = bindings;
  return { file, ...skinweights, jointFromBind, bindFromJoint, normals: cse169Shape.normals };
}

function checkTriangles(
  log: DiagnosticLog,
  { corners, lines }: Triangles,
  pointCount: number,
): void {
  const at = corners.findIndex((point) => point >= pointCount);
  if (at === -1) return;
  log.error({
    code: 'skin/index',
    line: lines[Math.floor(at / 3)]!,
    expected: `vertices from 0 to ${pointCount - 1}`,
    found: `${corners[at]!}`,
    effect,
  });
}

function checkNormals(log: DiagnosticLog, normals: Section | undefined, pointCount: number): void {
  const computed = 'they are computed from the triangles';
  if (!normals) {
    log.warn({ code: 'skin/normal', expected: 'normals', found: 'none', effect: computed });
    return;
  }
  if (normals.count !== pointCount) {
    const expected = `${pointCount} normals, one for each position`;
    const found = `${normals.count}`;
    log.error({ code: 'skin/count', expected, found, effect });
    return;
  }
  const { values } = normals;
  const withoutLength: number[] = [];
  for (let i = 0; i < values.length; i += 3) {
    const [x, y, z] = [values[i]!, values[i + 1]!, values[i + 2]!];
    if (!(x * x + y * y + z * z > 1e-24)) withoutLength.push(i / 3);
  }
  const [first] = withoutLength;
  if (first === undefined) return;
  log.warn({
    code: 'skin/normal',
    line: normals.lines[first]!,
    expected: 'normals with a length',
    found: `${withoutLength.length} without`,
    effect: computed,
  });
}

function uvsThatFit(
  log: DiagnosticLog,
  texcoords: Section | undefined,
  pointCount: number,
): Section | undefined {
  if (!texcoords || texcoords.count === pointCount) return texcoords;
  log.warn({
    code: 'skin/uv',
    expected: `${pointCount} texcoords, one for each position`,
    found: `${texcoords.count}`,
    effect: 'they are not used',
  });
  return undefined;
}
