import { jointTree, treeAngles } from '../data/joint-tree.ts';
import { type BenchOptions, type GroupResult, timesFaster } from '../harness/group.ts';
import { contenderOf, measure } from '../harness/measure.ts';
import { checkKinematics, type Kinematics, sinewKinematics } from '../kinematics/sinew.ts';
import { loadPeer } from '../harness/load-peer.ts';

const jointCount = 1000;
const poseCount = 8;

/** Forward kinematics against three.js. */
export async function kinematics({ rounds }: BenchOptions): Promise<GroupResult> {
  const tree = jointTree(jointCount);
  const peer = await loadPeer<{
    threeKinematics: (parents: readonly number[], offsets: Float64Array) => Kinematics;
  }>('three-kinematics');
  const poses = Array.from({ length: poseCount }, (_, pose) => treeAngles(jointCount, pose));
  const programs = {
    sinew: sinewKinematics(tree),
    three: peer.threeKinematics(tree.parents, tree.offsets),
  };
  const contenders = Object.entries(programs).map(([id, program]) => {
    checkKinematics(id, program, tree, poses[1]!);
    return contenderOf(id, (index) => program.run(poses[index % poseCount]!));
  });
  const samples = await measure(contenders, rounds);
  return {
    samples,
    values: { kinematics: timesFaster(samples, 'sinew', 'three') },
    counts: { joints: jointCount },
  };
}
