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

/** Limbs bend as far as they can and farther, where the artifacts of linear blending show. */
export const hardPose: PoseJson = {
  joints: {
    Spine: [0.5, 0.5, 0],
    Head: [-0.3, -0.6, 0],
    'Left upper arm': [0, -0.3, 0.9],
    'Left forearm': [0.4, -2.1, 0],
    'Right upper arm': [1.2, 0, -0.4],
    'Right forearm': [1.6, 0.6, 0],
    'Right hand': [0, 0, 1.2],
    'Left upper leg': [-1.4, 0, 0.2],
    'Left lower leg': [2, 0, 0],
    'Right upper leg': [-1.2, 0, -0.3],
    'Right lower leg': [2.2, 0, 0],
  },
};
