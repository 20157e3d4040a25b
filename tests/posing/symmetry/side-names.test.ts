import { describe, expect, it } from 'vitest';
import { sideOfJoint, sideOfName } from '../../../src/posing/symmetry/side-names.ts';

describe('the side in a name', () => {
  it.each([
    ['Left upper arm', 'left', '* upper arm'],
    ['Right fingers', 'right', '* fingers'],
    ['Left hind lower leg', 'left', '* hind lower leg'],
    ['shoulder_right_2', 'right', 'shoulder_*_2'],
    ['knuckle_1_2_left_1 (2)', 'left', 'knuckle_1_2_*_1 (2)'],
    ['wing_1_left', 'left', 'wing_1_*'],
    ['hip_01_r', 'right', 'hip_01_*'],
    ['leg_l1_coxa', 'left', 'leg_*1_coxa'],
    ['leg_hind_r_upper', 'right', 'leg_hind_*_upper'],
    ['antenna_l_scape', 'left', 'antenna_*_scape'],
    ['wing_r_fold', 'right', 'wing_*_fold'],
    ['mixamorig:LeftForeArm', 'left', 'mixamorig:*forearm'],
    ['rightHand', 'right', '*hand'],
    ['leftarm', 'left', '*arm'],
    ['lShldr', 'left', '*shldr'],
    ['RArm', 'right', '*arm'],
    ['L_Arm', 'left', '*_arm'],
    ['Bip01 R UpperArm', 'right', 'bip01 * upperarm'],
    ['upperarm.L', 'left', 'upperarm.*'],
    ['thigh.R.001', 'right', 'thigh.*.001'],
    ['hand-r', 'right', 'hand-*'],
    ['LEFT_FOOT', 'left', '*_foot'],
    ['左ひじ', 'left', '*ひじ'],
    ['右足ＩＫ', 'right', '*足ik'],
    ['左ﾏﾌﾗｰ１', 'left', '*マフラー1'],
    ['腕Ｌ', 'left', '腕*'],
    ['arm_L', 'left', 'arm_*'],
  ])('%s: %s', (name, side, stem) => {
    expect(sideOfName(name)).toEqual({ side, stem });
  });

  it.each([
    ...['Head', 'Spine', 'Lower jaw', 'Tail 12', 'Root', 'joint 03', 'body_1', 'センター', '両目'],
    ...['Collar', 'Bright', 'Relay', 'Wrist', 'Ring metacarpal', 'Little tip', 'upright', ''],
  ])('%s names none', (name) => {
    expect(sideOfName(name)).toBeNull();
  });

  it('comes from the English name where the other tells none', () => {
    const skeleton = { names: ['腕', '頭'], englishNames: ['arm_R', ''] };
    expect(sideOfJoint(skeleton, 0)).toEqual({ side: 'right', stem: 'arm_*' });
    expect(sideOfJoint(skeleton, 1)).toBeNull();
  });
});
