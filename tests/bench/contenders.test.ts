import { describe, expect, it } from 'vitest';
import { courseFiles } from '../../bench/data/course-files.ts';
import { cylinder, poseAngles } from '../../bench/data/cylinder.ts';
import { jointTree, treeAngles } from '../../bench/data/joint-tree.ts';
import { checkSkinned, transformsOf } from '../../bench/data/oracle.ts';
import { checkKinematics, sinewKinematics } from '../../bench/kinematics/sinew.ts';
import { checkReadFile } from '../../bench/readers/check.ts';
import { readerKinds, sinewReaders } from '../../bench/readers/sinew.ts';
import { posedBody, strictSkinning, wasmSkinning } from '../../bench/skinning/sinew.ts';

// Sinew's own contenders run once, so that a change that breaks the bench is noticed. No time is
// measured.

describe("Sinew's contenders give right answers", () => {
  it.each(['four', 'varied'] as const)('in skinning, with %s influences', async (influences) => {
    const body = cylinder({ vertexCount: 1000, influences });
    const angles = poseAngles(body.jointCount, 1);
    const posed = posedBody(body, angles);
    const transforms = transformsOf(body, angles);
    for (const program of [strictSkinning(posed), await wasmSkinning(posed, true)]) {
      program.run();
      const answer = { id: 'sinew', positions: program.positions, normals: program.normals! };
      checkSkinned(answer, body, posed.character.mesh, transforms);
    }
    const atRest = { id: 'rest', positions: body.positions };
    expect(() => checkSkinned(atRest, body, posed.character.mesh, transforms)).toThrow('rest');
  });

  it('in forward kinematics', () => {
    const tree = jointTree(100);
    const angles = treeAngles(100, 1);
    checkKinematics('sinew', sinewKinematics(tree), tree, angles);
    const lazy = { run: () => undefined, matrices: () => new Float64Array(1600) };
    expect(() => checkKinematics('lazy', lazy, tree, angles)).toThrow('lazy');
  });

  it.each(readerKinds)('in reading .%s', async (kind) => {
    const body = cylinder({ vertexCount: 1000 });
    const found = await sinewReaders[kind](courseFiles[kind](body));
    checkReadFile(kind, found, body);
    const other = cylinder({ vertexCount: 1020 });
    expect(() => checkReadFile(kind, found, other)).toThrow(kind);
  });
});
