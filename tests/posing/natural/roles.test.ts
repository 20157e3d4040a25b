import { describe, expect, it } from 'vitest';
import { buildSkeleton } from '../../../src/core/build-skeleton.ts';
import { DiagnosticLog } from '../../../src/core/diagnostics.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import type { Skeleton } from '../../../src/core/skeleton.ts';
import { namedRoles } from '../../../src/posing/natural/name-roles.ts';
import { shapedRoles } from '../../../src/posing/natural/shape-roles.ts';
import { naturesOf } from '../../../src/posing/natural/natures.ts';
import { bodyOf } from '../../../src/posing/natural/body.ts';
import { bundledIds, readBundled } from '../../support/bundled.ts';

/** A skeleton of these joints; two spaces more than the line above begin a child. */
function skeletonOf(lines: string): Skeleton {
  const above: number[] = [];
  const joints = lines
    .split('\n')
    .filter((line) => line.trim() !== '')
    .map((line, index) => {
      const depth = (line.length - line.trimStart().length) / 2;
      above[depth] = index;
      const parent = depth === 0 ? -1 : above[depth - 1]!;
      return { name: line.trim(), parent, restOffset: [0, 1, 0] as const, dofs: [] };
    });
  return buildSkeleton({ file: 'made', joints }, new DiagnosticLog('made'))!;
}

function placesIn(skeleton: Skeleton) {
  const matrices = jointMatrices(skeleton, skeleton.qRest);
  return skeleton.names.map((_, joint) => matrices.slice(joint * 16 + 12, joint * 16 + 15));
}

/** "name: role" of every joint that has one. */
function rolesIn(skeleton: Skeleton): string[] {
  const { roles } = namedRoles(skeleton);
  return skeleton.names.flatMap((name, joint) =>
    roles[joint] ? [`${name}: ${roles[joint]}`] : [],
  );
}

describe('roles by names', () => {
  it.each([
    [
      'Mixamo',
      `mixamorig:Hips
  mixamorig:Spine
    mixamorig:Neck
      mixamorig:Head
    mixamorig:LeftShoulder
      mixamorig:LeftArm
        mixamorig:LeftForeArm
          mixamorig:LeftHand
            mixamorig:LeftHandThumb1
            mixamorig:LeftHandIndex1
  mixamorig:LeftUpLeg
    mixamorig:LeftLeg
      mixamorig:LeftFoot
        mixamorig:LeftToeBase`,
      ...[['pelvis', 'spine', 'neck', 'head', 'clavicle', 'shoulder', 'elbow', 'wrist', 'thumb']],
      ['finger', 'hip', 'knee', 'ankle', 'toe'],
    ],
    [
      'Unreal',
      `pelvis
  spine_01
    clavicle_r
      upperarm_r
        lowerarm_r
          hand_r
            index_01_r
          lowerarm_twist_01_r
  thigh_r
    calf_r
      foot_r
        ball_r`,
      ...[['pelvis', 'spine', 'clavicle', 'shoulder', 'elbow', 'wrist', 'finger', 'twist']],
      ['hip', 'knee', 'ankle', 'toe'],
    ],
    [
      'Rigify',
      `spine
  shoulder.L
    upper_arm.L
      forearm.L
        hand.L
          f_ring.01.L
  thigh.L
    shin.L
      foot.L`,
      ['spine', 'clavicle', 'shoulder', 'elbow', 'wrist', 'finger'],
      ['hip', 'knee', 'ankle'],
    ],
    [
      'PMD',
      `センター
  上半身
    上半身2
      首
        頭
      左肩
        左腕
          左腕捩
            左ひじ
              左手捩
                左手首
                  左親指１
                  左人差指１
  下半身
    左足
      左ひざ
        左足首
          左つま先`,
      ['root', 'spine', 'spine', 'neck', 'head', 'clavicle', 'shoulder', 'twist', 'elbow'],
      ['twist', 'wrist', 'thumb', 'finger', 'pelvis', 'hip', 'knee', 'ankle', 'toe'],
    ],
    [
      'the course',
      `Root
  Chest
    Waist
      Right hip
        Right leg
          Right knee
            Right foot
  Right collarbone
    Right shoulder
      Right elbow`,
      ['root', 'spine', 'spine', 'pelvis', 'hip', 'knee', 'ankle'],
      ['clavicle', 'shoulder', 'elbow'],
    ],
  ])('are those of %s', (_, lines, ...roles) => {
    const skeleton = skeletonOf(lines);
    expect(namedRoles(skeleton).roles).toEqual(roles.flat());
  });

  it.each(['左足ＩＫ', '左ひじ先', '左足D', '肩P', '前髪１', 'Head_end', 'Hair', '左目', 'Tail 3'])(
    'leave out what has none: %s',
    (name) => {
      expect(rolesIn(skeletonOf(name))).toEqual([]);
    },
  );

  it('are not those of a human where limbs are others', () => {
    const wasp = ['1', '2', '3'].flatMap((pair) =>
      ['l', 'r'].map((side) => `  hip_0${pair}_${side}\n    knee_0${pair}_${side}`),
    );
    expect(rolesIn(skeletonOf(`body\n  head\n${wasp.join('\n')}`))).toEqual(['head: head']);
    expect(rolesIn(skeletonOf('shoulder\n  elbow'))).toEqual([]);
  });
});

describe('the bundled characters', () => {
  it.each([
    ['human', 30, 2, 2],
    ['hand', 15, 0, 0],
    ['dog', 18, 0, 0],
    ['panda', 6, 0, 0],
    ['insect', 1, 0, 0],
    ['tube', 0, 0, 0],
  ] as const)('have natures where their role is clear: %s', async (id, count, elbows, knees) => {
    const character = await readBundled(id);
    const { roles } = bodyOf(character);
    const having = (role: string): number => roles.filter((each) => each === role).length;
    expect(naturesOf(character)).toHaveLength(count);
    expect([having('elbow'), having('knee')]).toEqual([elbows, knees]);
    expect(bundledIds).toContain(id);
  });

  it('show their arms and legs by their shape where names tell nothing', async () => {
    const { skeleton } = await readBundled('human');
    const names = skeleton.names.map((_, joint) => `joint ${joint}`);
    const places = placesIn(skeleton);
    const { roles, sides } = shapedRoles(
      { ...skeleton, names },
      places,
      namedRoles({ ...skeleton, names }),
    );
    const named = namedRoles(skeleton);
    const found = roles.flatMap((role, joint) => (role ? [[role, sides[joint]]] : []));
    const expected = named.roles.flatMap((role, joint) =>
      roles[joint] ? [[role, named.sides[joint]]] : [],
    );
    expect(found).toEqual(expected);
    expect(found).toHaveLength(14);
    const dog = (await readBundled('dog')).skeleton;
    const nameless = { ...dog, names: dog.names.map((_, joint) => `joint ${joint}`) };
    expect(shapedRoles(nameless, placesIn(dog), namedRoles(nameless)).roles).not.toContain('knee');
  });

  it('bend their knees backward, and their elbows and fingers forward', async () => {
    const human = await readBundled('human');
    const { forward } = bodyOf(human);
    expect(Math.abs(forward![2] - 1)).toBeLessThan(1e-6);
    for (const { joint, bend, side } of naturesOf(human)) {
      const name = human.skeleton.names[joint]!;
      if (!/forearm|lower leg/.test(name)) continue;
      expect(bend[1] - bend[0]).toBeCloseTo((152 * Math.PI) / 180, 9);
      expect(side[1] - side[0]).toBeLessThan(0.2);
    }
  });
});
