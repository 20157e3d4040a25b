import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { vec3 } from 'gl-matrix';
import { beforeAll, describe, expect, it } from 'vitest';
import type { CatalogueScene } from '../../src/app/catalogue.ts';
import { transformOf } from '../../src/app/open-scene.ts';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { sceneBounds } from '../../src/evaluation/scene-bounds.ts';
import { readPoseJson } from '../../src/formats/read-pose-json.ts';
import { catalogue, readBundled } from '../support/bundled.ts';

// The first visit shows a person and a dog that meet, hand to paw.
const data = join(import.meta.dirname, '../../public/data');
const scene = catalogue.scenes[0]!;
let evaluators: Evaluator[] = [];

async function evaluated(actor: CatalogueScene['actors'][number], index: number) {
  const character = await readBundled(actor.character);
  const text = readFileSync(join(data, actor.pose), 'utf8');
  const { value, diagnostics } = readPoseJson(actor.pose, text, character.skeleton);
  expect(diagnostics).toEqual([]);
  const kept = { q: value!.q, transform: transformOf(actor.place) };
  return new Evaluator(createActor(index, character, 'linear-blend', kept));
}

beforeAll(async () => {
  evaluators = await Promise.all(scene.actors.map(evaluated));
});

/** The posed points that follow one of these joints most, in scene space. */
function pointsOf(evaluator: Evaluator, joint: RegExp): vec3[] {
  const { character } = evaluator.state;
  const { skin, mesh, skeleton } = character;
  const { positions } = evaluator.vertices();
  const points: vec3[] = [];
  for (let point = 0; point < mesh.pointCount; point++) {
    let heaviest = skin.start[point]!;
    for (let i = heaviest; i < skin.start[point + 1]!; i++) {
      if (skin.weights[i]! > skin.weights[heaviest]!) heaviest = i;
    }
    if (!joint.test(skeleton.names[skin.paletteJoint[skin.entries[heaviest]!]!]!)) continue;
    const at = positions.subarray(point * 3, point * 3 + 3) as unknown as vec3;
    points.push(vec3.transformMat4([0, 0, 0], at, evaluator.display.sceneFromCharacter));
  }
  return points;
}

describe('the first scene', () => {
  it('fits in the box that the camera frames, and stands on the floor', () => {
    const { min, max } = sceneBounds(evaluators);
    for (let axis = 0; axis < 3; axis++) {
      expect(scene.bounds.min[axis]).toBeCloseTo(min[axis]!, 1);
      expect(scene.bounds.max[axis]).toBeCloseTo(max[axis]!, 1);
    }
    for (const evaluator of evaluators) {
      expect(Math.abs(sceneBounds([evaluator]).min[1]!)).toBeLessThan(0.01);
    }
  });

  it('shows a hand that holds a paw', () => {
    const [person, dog] = evaluators as [Evaluator, Evaluator];
    const hand = pointsOf(person, /palm|fingers|thumb|hand/i);
    const body = pointsOf(dog, /./);
    const gaps = hand.map((at) =>
      Math.sqrt(
        body.reduce((least, other) => Math.min(least, vec3.squaredDistance(at, other)), Infinity),
      ),
    );
    expect(hand.length).toBeGreaterThan(100);
    // A person is one unit tall.
    expect(Math.min(...gaps)).toBeLessThan(0.01);
    expect(gaps.filter((gap) => gap < 0.03).length).toBeGreaterThan(20);
  });

  it('is loaded with 550 KB until its first picture, and 1.2 MB in all', () => {
    const scripts = 60_000;
    const bytesOf = scene.actors.map(({ character, pose }) => {
      const { files } = catalogue.characters.find(({ id }) => id === character)!;
      return [...files, pose].reduce((sum, file) => sum + statSync(join(data, file)).size, 0);
    });
    expect(scripts + bytesOf[0]!).toBeLessThan(550_000);
    expect(bytesOf.reduce((sum, bytes) => sum + bytes, 0)).toBeLessThan(1_200_000 - 250_000);
  });
});
