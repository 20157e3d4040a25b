import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { forwardKinematics } from '../../src/core/forward-kinematics.ts';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { characterOf } from '../data/character.ts';
import { cylinder, poseAngles } from '../data/cylinder.ts';
import type { GroupResult } from '../harness/group.ts';
import { plainUse } from '../../src/skinning/method.ts';

const vertexCount = 1000;
const poseCount = 16;
const frameCount = 64;
const attempts = 20;

/** The bytes of heap that a frame allocates, once its code is compiled. */
export function steadyState(): GroupResult {
  const body = cylinder({ vertexCount });
  const character = characterOf(body);
  const { skeleton, skin, mesh } = character;
  const poses = Array.from({ length: poseCount }, (_, pose) => poseAngles(body.jointCount, pose));

  const joints = new Float64Array(skeleton.jointCount * 16);
  const palette = new Float32Array(skin.paletteJoint.length * linearBlend.vec4sPerEntry(skin) * 4);
  const out = {
    positions: new Float32Array(mesh.vertexCount * 3),
    normals: new Float32Array(mesh.vertexCount * 3),
  };
  const onPath = bytesPerFrame((frame) => {
    forwardKinematics(skeleton, poses[frame % poseCount]!, joints);
    linearBlend.packPalette(skin, joints, palette);
    linearBlend.deform(mesh, skin, palette, out, plainUse);
  });

  const actor = createActor(1, character, 'linear-blend');
  const states = poses.map((q) => ({ ...actor, q }));
  const evaluator = new Evaluator(actor);
  const evaluated = bytesPerFrame((frame) => {
    evaluator.evaluate(states[frame % poseCount]!, 0).vertices();
  });
  return {
    samples: {},
    values: { heap: { value: onPath } },
    counts: { 'bytes of heap a frame, by the evaluator': evaluated },
  };
}

/**
 * The heap grows by what frames allocate until the garbage collector runs. The least of some
 * attempts leaves out what the engine allocates for itself at times.
 */
function bytesPerFrame(frame: (index: number) => void): number {
  setFlagsFromString('--expose-gc');
  const collect = runInNewContext('gc') as () => void;
  for (let i = 0; i < 2000; i++) frame(i);
  const grownBy = (count: number): number => {
    collect();
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < count; i++) frame(i);
    return process.memoryUsage().heapUsed - before;
  };
  const least = (count: number): number =>
    Math.min(...Array.from({ length: attempts }, () => grownBy(count)));
  return Math.max(0, Math.round((least(frameCount) - least(0)) / frameCount));
}
