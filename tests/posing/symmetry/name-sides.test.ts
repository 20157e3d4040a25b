import { expect, it } from 'vitest';
import { sidedName } from '../../../src/posing/symmetry/name-sides.ts';

it.each([
  ['Left upper arm', 'left', 'upper arm'],
  ['leg_l1_coxa', 'left', 'leg 1 coxa'],
  ['wing_2_1_left', 'left', 'wing 2 1'],
  ['Arm.L.001', 'left', 'arm 001'],
  ['lHand', 'left', 'hand'],
  ['LThigh', 'left', 'thigh'],
  ['rightarm', 'right', 'arm'],
  ['mixamorig:RightForeArm', 'right', 'mixamorig fore arm'],
  ['Bip01 R Thigh', 'right', 'bip 01 thigh'],
  ['upperarm_r', 'right', 'upperarm'],
  ['左ひじ', 'left', 'ひじ'],
  ['右ﾏﾌﾗｰ２', 'right', 'マフラー 2'],
  ['両目', null, '両目'],
  ['左右', null, '左 右'],
  ['R', null, 'r'],
  ['Lower back', null, 'lower back'],
])('parts a name into its side and the rest: %s', (name, side, stem) => {
  expect(sidedName(name)).toEqual({ side, stem });
});

it('gives both names of a pair one stem', () => {
  for (const [a, b] of [
    ['LeftHandThumb1', 'RightHandThumb1'],
    ['左足首', '右足首'],
    ['leg_front_l_toes', 'leg_front_r_toes'],
  ] as const) {
    expect(sidedName(a).stem).toBe(sidedName(b).stem);
  }
});
