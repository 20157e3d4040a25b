import type { Actor } from '../../document/scene.ts';
import type { MethodId } from '../../skinning/method.ts';
import type { EvaluationPool } from '../evaluation-pool.ts';
import { Evaluator } from '../evaluator.ts';
import { closedComponents } from './closed-components.ts';
import { jointSection } from './joint-section.ts';
import { outlineArea } from './outline.ts';
import { type TurnRange, turned } from './turn-range.ts';
import { volumeRatioOf } from './volume.ts';

/** What a method makes of a joint that turns over its range. */
export interface SweepCurve {
  readonly method: MethodId;
  /** The volume at each angle as a part of that at rest; all null if the mesh encloses none. */
  readonly volumes: readonly (number | null)[];
  /** The area of the section at each angle as a part of that at rest; all null without a section. */
  readonly sections: readonly (number | null)[];
}

/** Volume and cross-section of a character over the range of a joint's axis, by several methods. */
export interface Sweep {
  readonly range: TurnRange;
  /** In radians, from one end of the range to the other. */
  readonly angles: readonly number[];
  readonly curves: readonly SweepCurve[];
}

/**
 * Turns a joint about one axis from one end of its range to the other, in equal steps, while the rest
 * of the pose stays. The section is that of `jointSection`: its outline is cut once and then moves
 * with the skin, so that it is always the same part of the limb that is measured.
 *
 * The kernels and layers of the actor must be loaded for every method. It gives back the part that is
 * done after each pose, so that its caller can take its time.
 *
 * @param actor without a clip and pins, which would change the pose
 */
export function* sweepOf(
  pool: EvaluationPool,
  actor: Actor,
  methods: readonly MethodId[],
  range: TurnRange,
  steps: number,
): Generator<number, Sweep> {
  const { skeleton, mesh } = actor.character;
  // What is found once for a mesh takes longer than a pose; each is a part of the work of its own.
  closedComponents(mesh);
  yield 0;
  const section = jointSection(actor.character, range.joint);
  yield 0;
  const angles = Array.from(
    { length: steps + 1 },
    (_, i) => range.from + ((range.to - range.from) * i) / steps,
  );
  const curves = methods.map((method) => {
    return { method, volumes: [] as (number | null)[], sections: [] as (number | null)[] };
  });
  const evaluators = methods.map((method) => new Evaluator({ ...actor, method }, pool));
  let done = 0;
  try {
    for (const angle of angles) {
      const q = turned(skeleton, actor.q, range, angle);
      for (const [i, evaluator] of evaluators.entries()) {
        const posed = evaluator.evaluate({ ...actor, method: methods[i]!, q }, 0);
        const before = section && outlineArea(section, posed.rest.positions);
        const after = section && outlineArea(section, posed.vertices().positions);
        curves[i]!.volumes.push(volumeRatioOf(posed));
        curves[i]!.sections.push(before && after !== null ? after / before : null);
        yield ++done / (angles.length * methods.length);
      }
    }
  } finally {
    for (const evaluator of evaluators) evaluator.dispose();
  }
  return { range, angles, curves };
}
