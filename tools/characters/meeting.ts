import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { axisDofs } from '../../src/core/pose.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { displayTransform } from '../../src/evaluation/display-transform.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { rounded } from './insect/surface.ts';
import { solveDog } from './meeting/dog.ts';
import { type Figure, readFigure } from './meeting/figure.ts';
import { solvePerson } from './meeting/person.ts';
import type { Vector3 } from './vector.ts';

/** Where the paw lies in the hand, in the spaces of the person and of the dog, in meters. */
const IN_HAND: Vector3 = [-0.1, 0.41, 0.56];
const IN_PAW: Vector3 = [0.07, 0.41, 0.64];

const PERSON_FACE: Vector3 = [0, 1.16, 0.42];
const DOG_FACE: Vector3 = [0, 0.8, 0.5];

/** What is at the middle of the scene, x and z in the person's space in meters. */
const SCENE_CENTER = [-0.05, 0.5] as const;

/** Turns the scene so that the studio's camera sees both nearly from the side, hand and paw first. */
const SCENE_TURN = 1.78;

/** A point of the person's space in that of the dog, which faces the person, and the other way. */
function acrossFrom([x, y, z]: Vector3): Vector3 {
  return [IN_HAND[0] + IN_PAW[0] - x, y + IN_PAW[1] - IN_HAND[1], IN_HAND[2] + IN_PAW[2] - z];
}

/**
 * Makes the poses in which the human and the dog meet, hand to paw, from their bundled files, and
 * prints their places in the scene, for `catalogue.json`.
 */
export async function makeMeeting(dataFolder: string): Promise<void> {
  const person = await readFigure(dataFolder, 'human');
  const dog = await readFigure(dataFolder, 'dog');
  const folder = join(dataFolder, 'meeting');
  mkdirSync(folder, { recursive: true });
  const personPose = solvePerson(person, IN_HAND, acrossFrom(DOG_FACE));
  writePose(join(folder, 'human.pose.json'), person, personPose);
  const dogPose = solveDog(dog, IN_PAW, acrossFrom(PERSON_FACE));
  writePose(join(folder, 'dog.pose.json'), dog, dogPose);

  // The scene's unit is the height of the standing person.
  const unitsPerMeter = displayTransform(person.character).scale;
  console.log('human', placeInScene(person, [0, 0, 0], 0, unitsPerMeter));
  console.log('dog', placeInScene(dog, acrossFrom([0, 0, 0]), Math.PI, unitsPerMeter));
}

/**
 * Where the scene puts a figure so that both have the same unit: its place and turn from the middle
 * of its bounds at rest, as the app counts them.
 *
 * @param origin of the figure's space in the person's space, on the floor
 * @param turn of the figure's space in the person's space, about y
 */
function placeInScene(
  { character }: Figure,
  [originX, , originZ]: Vector3,
  turn: number,
  unitsPerMeter: number,
) {
  const { min, max } = character.bounds;
  const [middleX, middleZ] = [(min[0]! + max[0]!) / 2, (min[2]! + max[2]!) / 2];
  const [x, z] = turned([middleX, middleZ], turn);
  const fromCenter = [originX + x - SCENE_CENTER[0], originZ + z - SCENE_CENTER[1]] as const;
  const [sceneX, sceneZ] = turned(fromCenter, SCENE_TURN).map((value) => value * unitsPerMeter);
  const scale = unitsPerMeter / displayTransform(character).scale;
  const [...numbers] = rounded([sceneX!, sceneZ!, turn + SCENE_TURN, scale], 4);
  return { x: numbers[0], z: numbers[1], turn: numbers[2], scale: numbers[3] };
}

/** Turns x and z about +y. */
function turned([x, z]: readonly [number, number], angle: number): [number, number] {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  return [cosine * x + sine * z, cosine * z - sine * x];
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
