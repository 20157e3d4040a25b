import type { SkinningMethod, VertexStreams } from '../../src/skinning/method.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { characterOfRig, qOfValues } from '../fixtures/character-of-rig.ts';
import { type Rig, transformsOf } from '../fixtures/rig.ts';
import type { Values } from '../reference/kinematics.ts';
import { rotationCenters } from '../reference/centers-of-rotation.ts';
import { type Vertex } from '../reference/skinned-vertex.ts';
import { type MethodOracle, methodOracles } from '../reference/skinning.ts';
import { numbersAt } from '../support/compare.ts';

/** Skins the rig for these values with the product's code. */
export function skinRig(rig: Rig, method: SkinningMethod, values: Values): VertexStreams {
  const character = characterOfRig(rig);
  const pose = { q: qOfValues(character.skeleton, values) };
  return skinVertices(character, character.skin, pose, method);
}

/** Does the same with the oracle. Rest normals are the product's, which have tests of their own. */
export function skinRigByOracle(
  rig: Rig,
  method: SkinningMethod,
  values: Values,
): { positions: number[]; normals: number[] } {
  const { mesh } = characterOfRig(rig);
  const oracle = oracleOf(method);
  const transforms = transformsOf(rig, values);
  const centers = method.id === 'centers-of-rotation' ? centersOf(rig) : null;
  const vertices = rig.points.map((position, point): Vertex => {
    const normal = numbersAt(mesh.normals, point, 3);
    const center = centers?.[point] ?? null;
    return { position, normal, influences: rig.rows[point]!, center };
  });
  const skinned = vertices.map((vertex) => oracle.position(vertex, transforms));
  const skinnedNormals = vertices.map((vertex) => oracle.normal(vertex, transforms));
  const finished = oracle.finish?.({
    triangles: rig.triangles,
    rest: rig.points,
    restNormals: vertices.map(({ normal }) => normal),
    skinned,
  });
  return {
    positions: (finished?.positions ?? skinned).flat(),
    normals: (finished?.normals ?? skinnedNormals).flat(),
  };
}

const knownCenters = new WeakMap<Rig, ReturnType<typeof rotationCenters>>();

function centersOf(rig: Rig): ReturnType<typeof rotationCenters> {
  let centers = knownCenters.get(rig);
  if (!centers) {
    // Points without weights follow the first root.
    const root = rig.joints.findIndex(({ parent }) => parent === -1);
    const rows = rig.rows.map((row) => (row.length > 0 ? row : [[root, 1] as const]));
    centers = rotationCenters(rig.points, rig.triangles, rows);
    knownCenters.set(rig, centers);
  }
  return centers;
}

export function oracleOf({ id }: SkinningMethod): MethodOracle {
  const oracle = methodOracles[id];
  if (!oracle) throw new Error(`the method ${id} needs an oracle in tests/reference/skinning.ts`);
  return oracle;
}
