import { expect } from 'vitest';
import { bonesOf } from '../../src/core/bones.ts';
import type { Character } from '../../src/core/character.ts';
import { normalizeSkin } from '../../src/core/skin.ts';
import { restPose } from '../../src/core/pose.ts';
import { loadedKernels } from './kernels.ts';
import { skinVertices } from './skin-vertices.ts';

/** Expects what holds for every character, whatever file it came from. */
export function expectSound(character: Character): void {
  const { skeleton, mesh, skin, bounds } = character;
  const bones = bonesOf(character);
  const { jointCount } = skeleton;
  expect(jointCount + mesh.pointCount).toBeGreaterThan(0);
  skeleton.parents.forEach((parent, joint) => {
    expect(parent).toBeLessThan(joint);
    expect(parent).toBeGreaterThanOrEqual(-1);
  });
  expect(new Set(skeleton.names).size).toBe(jointCount);
  expect(below(mesh.indices, mesh.vertexCount)).toBe(true);
  expect(below(mesh.pointOf, mesh.pointCount)).toBe(true);
  expect(skin.start).toHaveLength(mesh.pointCount + 1);
  expect(below(skin.entries, skin.paletteJoint.length)).toBe(true);
  expect(allFinite(skin.weights) && allFinite(skin.jointFromBind)).toBe(true);
  expect(bones.every(({ vector }) => allFinite(vector))).toBe(true);
  expect(allFinite(bounds.min) && allFinite(bounds.max)).toBe(true);
  expectUnit(mesh.normals);
  const cornerCount = mesh.submeshes.reduce((sum, { indexCount }) => sum + indexCount, 0);
  expect(cornerCount).toBe(mesh.indices.length);
}

/** Expects that every method poses it without NaN, with unchanged and with normalized weights. */
export function expectPosable(character: Character): void {
  const pose = restPose(character.skeleton);
  for (const method of loadedKernels) {
    for (const skin of [character.skin, normalizeSkin(character.skin)]) {
      const { positions, normals } = skinVertices(character, skin, pose, method);
      expect(allFinite(positions)).toBe(true);
      expectUnit(normals);
    }
  }
}

function expectUnit(normals: Float32Array): void {
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!);
    if (!(Math.abs(length - 1) < 1e-5)) expect.fail(`normal ${i / 3} has length ${length}`);
  }
}

function below(values: ArrayLike<number>, bound: number): boolean {
  return Array.from(values).every((value) => value >= 0 && value < bound);
}

function allFinite(values: ArrayLike<number>): boolean {
  return Array.from(values).every(Number.isFinite);
}
