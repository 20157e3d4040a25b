import { copyFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildCharacter } from '../../src/core/build-character.ts';
import type {
  CharacterParts,
  JointParts,
  MeshParts,
  SkinParts,
} from '../../src/core/character-parts.ts';
import { ballHinges, rootSlides } from '../../src/formats/cse169/joint-dofs.ts';
import { writeAnim } from '../../src/formats/cse169/write-anim.ts';
import { writeCse169 } from '../../src/formats/cse169/write-character.ts';
import { writeGzip } from './gzip-file.ts';
import { rounded } from './insect/surface.ts';
import { type JointTable, readJointTable } from './joint-table.ts';
import { roundWeights } from './mit-text.ts';
import { type PandaSource, readPanda } from './panda-source.ts';
import { pandaWalk } from './panda-walk.ts';
import { add, subtract, type Vector3 } from './vector.ts';

const WEIGHT_STEPS = 1000;

/** Half a side of the box of a joint that no vertex follows most, in meters. */
const SMALL_BOX = 0.01;

/**
 * Makes the panda's `.skel`, `.skin` and `.anim`, gzipped, and its texture, from the folder
 * `panda3d/models` of the Python package panda3d. Joints stand unturned where the mesh is bound.
 * The paws are on the floor, with their middle at the origin.
 */
export function makePanda(sourceFolder: string, dataFolder: string): void {
  const source = readPanda(sourceFolder);
  const table = readJointTable('panda');
  const { value: character, diagnostics } = buildCharacter(partsOf(source, table));
  if (!character || diagnostics.length > 0) throw new Error(JSON.stringify(diagnostics));
  const folder = join(dataFolder, 'panda');
  mkdirSync(folder, { recursive: true });
  const walk = { path: 'panda_walk.anim', bytes: writeAnim(pandaWalk(source, table)) };
  for (const { path, bytes } of [...writeCse169(character).files, walk]) {
    const size = writeGzip(join(folder, `${path}.gz`), new TextDecoder().decode(bytes));
    console.log(`${path}.gz: ${size} bytes`);
  }
  copyFileSync(join(sourceFolder, 'maps/panda-model.jpg'), join(folder, 'panda.jpg'));
}

function partsOf(source: PandaSource, table: JointTable): CharacterParts {
  const { names, parents, bones } = table;
  const [low, high] = [0, 1].map((end) =>
    source.positions
      .map(([, y, z]) => [y, z])
      .reduce((a, b) =>
        a.map((value, axis) => {
          return end === 0 ? Math.min(value, b[axis]!) : Math.max(value, b[axis]!);
        }),
      ),
  );
  const center: Vector3 = [0, -low![0]!, -(low![1]! + high![1]!) / 2];
  // Rounded first, so that offsets and bindings agree exactly.
  const places = bones.map((bone): Vector3 => {
    const place = add(source.bones.get(bone === '' ? 'Dummy_hips' : bone)!, center);
    const [x, y, z] = rounded(place, 5);
    return [x!, y!, z!];
  });
  const positions = source.positions.map((point) => add(point, center));
  const skin = skinParts(source, table, places);
  const boxes = boxesOf(positions, skin, places);
  const joints = names.map((name, joint): JointParts => {
    const parent = parents[joint]!;
    const offset = parent < 0 ? places[joint]! : subtract(places[joint]!, places[parent]!);
    const [x, y, z] = rounded(offset, 5);
    const hinges = ballHinges([0, 0, 0], []);
    return {
      ...{ name, fileName: name, parent, restOffset: [x!, y!, z!], displayBox: boxes[joint]! },
      dofs: parent < 0 ? [...rootSlides, ...hinges] : hinges,
    };
  });
  return {
    ...{ name: 'panda', missing: [], skin },
    skeleton: { file: 'panda.skel', joints },
    mesh: meshParts(source, positions),
  };
}

function meshParts(source: PandaSource, positions: readonly Vector3[]): MeshParts {
  const corners = source.triangles.flat();
  return {
    file: 'panda.skin',
    positions: Float32Array.from(rounded(positions.flat(), 4)),
    normals: Float32Array.from(rounded(source.normals.flat(), 3)),
    uvs: Float32Array.from(rounded(source.textureCoordinates.flat(), 4)),
    cornerPoints: Uint32Array.from(corners),
    cornerNormals: Int32Array.from(corners),
    cornerUvs: Int32Array.from(corners),
    materials: [{ name: 'panda', texture: 'panda.jpg' }],
    submeshes: [{ material: 'panda', firstTriangle: 0 }],
  };
}

/** Weights are whole thousandths, so that a row sums to 1. */
function skinParts(
  { weights: rows }: PandaSource,
  { bones }: JointTable,
  places: readonly Vector3[],
): SkinParts {
  const start = [0];
  const joints: number[] = [];
  const weights: number[] = [];
  for (const row of rows) {
    const steps = roundWeights(
      bones.map((bone) => row.get(bone) ?? 0),
      WEIGHT_STEPS,
    );
    for (const [joint, count] of steps.entries()) {
      if (count === 0) continue;
      joints.push(joint);
      weights.push(count / WEIGHT_STEPS);
    }
    start.push(joints.length);
  }
  const bindFromJoint = places.flatMap((place) => [
    ...[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
    ...[...rounded(place, 5), 1],
  ]);
  return {
    file: 'panda.skin',
    start: Uint32Array.from(start),
    joints: Uint16Array.from(joints),
    weights: Float32Array.from(weights),
    bindFromJoint: Float64Array.from(bindFromJoint),
  };
}

/** Boxes around the vertices that follow a joint most, in the joint's frame. */
function boxesOf(
  positions: readonly Vector3[],
  { start, joints, weights }: SkinParts,
  places: readonly Vector3[],
): (readonly number[])[] {
  const followers = places.map((): Vector3[] => []);
  for (const [vertex, point] of positions.entries()) {
    const row = weights.subarray(start[vertex], start[vertex + 1]);
    const joint = joints[start[vertex]! + row.indexOf(Math.max(...row))]!;
    followers[joint]!.push(subtract(point, places[joint]!));
  }
  return followers.map((points) => {
    const corner = (end: (...values: number[]) => number, otherwise: number): number[] =>
      [0, 1, 2].map((axis) => {
        return points.length === 0 ? otherwise : end(...points.map((point) => point[axis]!));
      });
    return rounded([...corner(Math.min, -SMALL_BOX), ...corner(Math.max, SMALL_BOX)], 4);
  });
}
