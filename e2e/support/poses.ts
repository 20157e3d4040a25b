import type { PoseJson } from '../../src/formats/pose-json.ts';
import { randomBetween, randomSource } from '../../tests/support/random.ts';

/** Rotates every joint far about every axis, and moves the root; the same in every run. */
export function wildPose(jointCount: number, seed: number): PoseJson {
  const random = randomSource(seed);
  const triple = (reach: number): [number, number, number] => [
    randomBetween(random, -reach, reach),
    randomBetween(random, -reach, reach),
    randomBetween(random, -reach, reach),
  ];
  const joints = Array.from(
    { length: jointCount },
    (_, joint) => [`#${joint}`, triple(2)] as const,
  );
  return { joints: Object.fromEntries(joints), root: triple(0.3) };
}
