import { describe, expect, it } from 'vitest';
import { type Bone, bonesOf } from '../../src/core/bones.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import type { Rig } from '../fixtures/rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import type { Joint } from '../reference/kinematics.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { readOne } from '../support/files.ts';
import { tolerances } from '../tolerances.ts';

const still = [0, 0, 0, 1];
const quarterTurn = [0, 0, Math.SQRT1_2, Math.SQRT1_2];

function joint(parent: number, offset: readonly number[], rotation = still): Joint {
  return { parent, offset, rotation, freedoms: [] };
}

function bonesOfRig(joints: readonly Joint[], skin: Pick<Rig, 'points' | 'rows'>): readonly Bone[] {
  const triangles = skin.points.length > 0 ? [[0, 0, 0]] : [];
  const rest = joints.map(() => []);
  return bonesOf(characterOfRig({ joints, rest, triangles, ...skin }));
}

const noSkin = { points: [], rows: [] };

describe('deriveBones', () => {
  it("gives the course's model a bone for forearms, head and feet, none where joints meet", async () => {
    const character = await readOne({ 'a.skel': courseSkel });
    const { skeleton } = character;
    const bones = bonesOf(character);
    const ends = bones.map(({ joint, child }) => [
      skeleton.names[joint],
      child === -1 ? 'tip' : skeleton.names[child],
    ]);
    expect(ends).toEqual([
      ['Chest', 'Waist'],
      ['Waist', 'Right hip'],
      ['Waist', 'Left hip'],
      ['Right hip', 'Right leg'],
      ['Right leg', 'Right knee'],
      ['Right knee', 'Right foot'],
      ['Right foot', 'tip'],
      ['Left hip', 'Left leg'],
      ['Left leg', 'Left knee'],
      ['Left knee', 'Left foot'],
      ['Left foot', 'tip'],
      ['Right collarbone', 'Right shoulder'],
      ['Right shoulder', 'Right elbow'],
      ['Right elbow', 'tip'],
      ['Left collarbone', 'Left shoulder'],
      ['Left shoulder', 'Left elbow'],
      ['Left elbow', 'tip'],
    ]);
    const foot = bones.find(({ joint }) => skeleton.names[joint] === 'Left foot');
    expect(foot?.vector).toEqual([0, -1.2, 0]);
  });

  it('ends a leaf nine tenths of the way through the points that mostly follow it', () => {
    const bones = bonesOfRig([joint(-1, [0, 0, 0]), joint(0, [1, 0, 0])], {
      points: [
        [1, 1, 0],
        [1, 2, 0],
        [5, 5, 5],
      ],
      rows: [
        [[1, 1]],
        [
          [0, 0.4],
          [1, 0.6],
        ],
        [
          [0, 0.5],
          [1, 0.5],
        ],
      ],
    });
    expect(bones.map(({ joint, child }) => [joint, child])).toEqual([
      [0, 1],
      [1, -1],
    ]);
    expect(largestDifference(bones[1]!.vector, [0, 1.8, 0])).toBeLessThan(tolerances.float32);
  });

  it('tells vectors in the frame of their joint, turned as it may be', () => {
    // The second joint is rotated by 90° about z, so the character's +y is its own +x.
    const joints = [joint(-1, [0, 0, 0]), joint(0, [1, 0, 0], quarterTurn), joint(1, [0, 2, 0])];
    const withSkin = bonesOfRig(joints.slice(0, 2), { points: [[1, 3, 0]], rows: [[[1, 1]]] });
    expect(largestDifference(withSkin[1]!.vector, [2.7, 0, 0])).toBeLessThan(tolerances.float32);
    expect(bonesOfRig(joints, noSkin)[1]!.vector).toEqual([0, 2, 0]);
    // Without a skin, the tip continues in its parent's direction: the character's +x, its own −y.
    const extended = bonesOfRig(joints.slice(0, 2), noSkin);
    expect(largestDifference(extended[1]!.vector, [0, -0.6, 0])).toBeLessThan(1e-12);
  });

  it('gives none to links without length and to a lone root', () => {
    expect(bonesOfRig([joint(-1, [1, 2, 3])], noSkin)).toEqual([]);
    expect(bonesOfRig([joint(-1, [0, 0, 0]), joint(0, [0, 0, 0])], noSkin)).toEqual([]);
    // All points at the joint, and points whose centroid is the joint, have no direction.
    const around = {
      points: [
        [1, 0, 0],
        [-1, 0, 0],
      ],
      rows: [[[0, 1] as const], [[0, 1] as const]],
    };
    expect(bonesOfRig([joint(-1, [0, 0, 0])], around)).toEqual([]);
  });

  it.each(Object.entries(allRigs))('is finite for the rig "%s"', (_, makeRig) => {
    const character = characterOfRig(makeRig());
    const { bounds } = character;
    const bones = bonesOf(character);
    expect(bones.length).toBeGreaterThan(3);
    for (const { vector } of bones) {
      expect(Math.hypot(...vector)).toBeGreaterThan(1e-8);
      expect(Math.hypot(...vector)).toBeLessThan(3);
    }
    expect(numbersAt(bounds.min, 0, 3).every(Number.isFinite)).toBe(true);
  });
});
