import { mat4 } from 'gl-matrix';
import type { SkinParts } from './character-parts.ts';
import type { DiagnosticLog } from './diagnostics.ts';
import { jointMatrices } from './forward-kinematics.ts';
import { linePlace, reportRows, type SkinRows } from './report-rows.ts';
import type { Skeleton } from './skeleton.ts';
import { firstRoot } from './subtree.ts';
import { noJoint, type Skin } from './skin.ts';

/** Smaller weights are numerical noise of a file; they would cost time without a visible effect. */
const smallestWeight = Math.fround(1e-6);
const sumTolerance = 1e-3;

/**
 * Packs the weights over a palette with one entry per joint, and reports rows that do not sum to
 * one. Weights stay as the file has them. A row without weights follows the first root rigidly. A
 * joint that does not exist is an error, and then there is no skin.
 */
export function buildSkin(
  parts: SkinParts,
  skeleton: Skeleton,
  log: DiagnosticLog,
): Skin | undefined {
  if (!jointsExist(parts, skeleton, log)) return undefined;
  const rows = packRows(parts, skeleton);
  reportRows(rows, parts.lines, log);
  return {
    ...rows.skin,
    paletteJoint: Uint16Array.from({ length: skeleton.jointCount }, (_, joint) => joint),
    jointFromBind: bindMatrices(parts, skeleton),
    normals: parts.normals ?? 'blended',
    ...(parts.bindFromJoint ? { bindFromJoint: inOrder(parts.bindFromJoint, skeleton) } : {}),
  };
}

/** Makes a skin for a mesh without weights: no point ever moves in the character's space. */
export function buildStaticSkin(pointCount: number): Skin {
  return {
    paletteJoint: Uint16Array.of(noJoint),
    jointFromBind: Float64Array.from(mat4.identity(new Float64Array(16))),
    start: Uint32Array.from({ length: pointCount + 1 }, (_, point) => point),
    entries: new Uint16Array(pointCount),
    weights: new Float32Array(pointCount).fill(1),
    normals: 'blended',
  };
}

function jointsExist(parts: SkinParts, { jointCount }: Skeleton, log: DiagnosticLog): boolean {
  const at = parts.joints.findIndex((joint) => joint >= jointCount);
  if (at === -1) return true;
  const point = parts.start.findIndex((start) => start > at) - 1;
  log.error({
    code: 'character/index',
    ...linePlace(parts.lines, point),
    expected: `joints from 0 to ${jointCount - 1}`,
    found: `joint ${parts.joints[at]!} at vertex ${point + 1}`,
    effect: 'the mesh is shown without its weights',
  });
  return false;
}

function packRows(parts: SkinParts, skeleton: Skeleton): SkinRows {
  const pointCount = parts.start.length - 1;
  const root = firstRoot(skeleton);
  const start = new Uint32Array(pointCount + 1);
  // A row without weights gets one.
  const entries = new Uint16Array(parts.weights.length + pointCount);
  const weights = new Float32Array(entries.length);
  let filled = 0;
  const zeroRows: number[] = [];
  const negativeRows: number[] = [];
  const unevenRows: { point: number; sum: number }[] = [];
  for (let point = 0; point < pointCount; point++) {
    let sum = 0;
    let negative = false;
    for (let i = parts.start[point]!; i < parts.start[point + 1]!; i++) {
      const weight = parts.weights[i]!;
      if (Math.abs(weight) < smallestWeight) continue;
      entries[filled] = skeleton.jointOfSource[parts.joints[i]!]!;
      weights[filled++] = weight;
      sum += weight;
      negative ||= weight < 0;
    }
    if (filled === start[point]!) {
      zeroRows.push(point);
      entries[filled] = root;
      weights[filled++] = 1;
    } else if (!(Math.abs(sum - 1) <= sumTolerance)) unevenRows.push({ point, sum });
    if (negative) negativeRows.push(point);
    start[point + 1] = filled;
  }
  const skin = { start, entries: entries.slice(0, filled), weights: weights.slice(0, filled) };
  return { skin, zeroRows, negativeRows, unevenRows };
}

/** The file's inverse bind matrices, or else the inverses of the rest pose's world matrices. */
function bindMatrices(parts: SkinParts, skeleton: Skeleton): Float64Array {
  if (parts.jointFromBind) return inOrder(parts.jointFromBind, skeleton);
  const jointFromBind = new Float64Array(skeleton.jointCount * 16);
  const bindFromJoint = jointMatrices(skeleton, skeleton.qRest);
  for (let joint = 0; joint < skeleton.jointCount; joint++) {
    const range = [joint * 16, joint * 16 + 16] as const;
    mat4.invert(jointFromBind.subarray(...range), bindFromJoint.subarray(...range));
  }
  return jointFromBind;
}

/** Reorders matrices from file order to the skeleton's joint order. */
function inOrder(matrices: Float64Array, { sourceIndex }: Skeleton): Float64Array {
  const sorted = new Float64Array(sourceIndex.length * 16);
  sourceIndex.forEach((source, joint) => {
    sorted.set(matrices.subarray(source * 16, source * 16 + 16), joint * 16);
  });
  return sorted;
}
