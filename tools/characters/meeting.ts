import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { axisDofs } from '../../src/core/pose.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { rounded } from './insect/surface.ts';
import { solveDog } from './meeting/dog.ts';
import { type Figure, readFigure } from './meeting/figure.ts';
import { solvePerson } from './meeting/person.ts';
import { add, type Vector3 } from './vector.ts';

/** Where the paw lies in the hand, in the spaces of the person and of the dog, in meters. */
const IN_HAND: Vector3 = [-0.1, 0.41, 0.56];
const IN_PAW: Vector3 = [0.07, 0.41, 0.64];

const PERSON_FACE: Vector3 = [0, 1.16, 0.42];
const DOG_FACE: Vector3 = [0, 0.8, 0.5];

/** A point of the person's space in that of the dog, which faces the person, and the other way. */
function acrossFrom([x, y, z]: Vector3): Vector3 {
  return [IN_HAND[0] + IN_PAW[0] - x, y + IN_PAW[1] - IN_HAND[1], IN_HAND[2] + IN_PAW[2] - z];
}

/**
 * Makes the poses in which the human and the dog meet, hand to paw, from their bundled files.
 */
export async function makeMeeting(dataFolder: string): Promise<void> {
  const person = await readFigure(dataFolder, 'human');
  const dog = await readFigure(dataFolder, 'dog');
  const folder = join(dataFolder, 'meeting');
  mkdirSync(folder, { recursive: true });
  writePose(
    join(folder, 'human.pose.json'),
    person,
    solvePerson(person, IN_HAND, acrossFrom(DOG_FACE)),
  );
  writePose(join(folder, 'dog.pose.json'), dog, solveDog(dog, IN_PAW, acrossFrom(PERSON_FACE)));
  console.log('the dog is turned by half a turn, at', add(IN_HAND, IN_PAW).join(' '));
}

/** Writes the pose with the lowest point exactly on the floor. */
function writePose(path: string, figure: Figure, q: Float64Array): void {
  const { skeleton, mesh } = figure.character;
  const points = Array.from({ length: mesh.pointCount }, (_, point) => point);
  const heightDof = axisDofs(skeleton, 0).find(({ kind, axis }) => {
    return kind === DofKind.slide && axis === 1;
  })!;
  const standing = q.slice();
  standing[heightDof.index]! -= figure.posed(q).bottom(points);
  const pose = poseToJson(skeleton, { q: Float64Array.from(rounded(standing, 3)) });
  writeFileSync(path, `${JSON.stringify(pose, null, 2)}\n`);
}
