import type { Character } from '../../../src/core/character.ts';
import { createActor } from '../../../src/document/scene.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import { Kernels } from '../../../src/evaluation/kernels.ts';
import { EvaluationPool } from '../../../src/evaluation/evaluation-pool.ts';
import { readMotionText } from '../../../src/formats/motion/read-motion.ts';
import { bindMotion } from '../../../src/formats/motion/bind-motion.ts';
import { cycle, type Design, motionJson } from './curves.ts';

/** At so many equal parts of a cycle the lowest point of the skin is on the floor. */
const parts = 16;

/** Returns the design with a root whose height keeps the feet on the floor. */
export async function withFeetDown(design: Design, character: Character): Promise<Design> {
  const { root, length } = design;
  if (!root) return design;
  const read = readMotionText('motion', JSON.stringify(motionJson(design)));
  const clip = bindMotion(read.value!, character).value!;
  const actor = {
    ...createActor(1, { ...character, clips: [clip] }, 'linear-blend', { fitted: false }),
    clip: 0,
  };
  const kernels = new Kernels();
  await kernels.loadFor(actor);
  const evaluator = new Evaluator(actor, new EvaluationPool(kernels));
  const heights = Array.from({ length: parts }, (_, at) => {
    const { positions } = evaluator.evaluate(actor, (at * length) / parts).vertices();
    let lowest = Infinity;
    for (let i = 1; i < positions.length; i += 3) lowest = Math.min(lowest, positions[i]!);
    return -lowest;
  });
  const [x, , z] = root.place;
  return { ...design, root: { ...root, place: [x, cycle(length, heights), z] } };
}
