import { signal } from '@preact/signals-core';
import type { Actor } from '../../document/scene.ts';
import {
  type StressRow,
  type StressSuite,
  worstFirst,
} from '../../evaluation/comparison/stress.ts';
import { differenceOf } from '../../evaluation/comparison/difference.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { Evaluator } from '../../evaluation/evaluator.ts';
import { turnOfPage } from '../../view/turn-of-page.ts';
import type { Picture } from '../../view/picture/encode-picture.ts';
import { pictureInTurns } from '../../view/picture/picture-in-turns.ts';
import { jointCamera } from '../../view/picture/joint-camera.ts';
import type { Looking } from '../editor.ts';

/** The side of a picture in its own pixels: twice that on the page, for fine screens and for print. */
const side = 208;

/** The pictures of the worst poses of a suite, which come one after another. */
export class StressPictures {
  /** By the pose; in the order of the methods. */
  readonly drawn = signal<ReadonlyMap<StressRow, readonly Picture[]>>(new Map());
  /** The part that is done, or null while none are drawn. */
  readonly part = signal<number | null>(null);
  private readonly editor: Pick<Looking, 'viewer'>;
  private stop = new AbortController();

  constructor(editor: Pick<Looking, 'viewer'>) {
    this.editor = editor;
  }

  /** Stops; pictures that are there stay. */
  cancel(): void {
    this.stop.abort();
    this.part.value = null;
  }

  /**
   * Draws the worst poses anew, with one camera for all methods of a pose. The page goes on
   * meanwhile.
   *
   * @param actor as it was measured
   * @param count of poses
   */
  async draw({ rows, methods, base }: StressSuite, actor: Actor, count: number): Promise<void> {
    this.cancel();
    const { signal: stopped } = (this.stop = new AbortController());
    const { viewer } = this.editor;
    const chosen = worstFirst(rows).slice(0, count);
    this.drawn.value = new Map();
    const ids = [methods[base]!, ...methods.filter((_, i) => i !== base)];
    const { pool } = viewer.evaluations;
    const evaluators = ids.map((method) => new Evaluator({ ...actor, method }, pool));
    let done = 0;
    try {
      for (const { method, state, skin, use } of evaluators) {
        const warming = method.warmUp?.(state.character.mesh, skin, use.settings);
        while (warming?.next().done === false) await turnOfPage();
      }
      for (const row of chosen) {
        const posed = ids.map((method) => ({ ...actor, method, q: row.pose.q }));
        for (const [i, evaluator] of evaluators.entries()) {
          await turnOfPage();
          if (stopped.aborted) return;
          evaluator.evaluate(posed[i]!, 0).vertices();
        }
        const camera = await jointCamera(evaluators[0]!, row.pose, apartness(evaluators));
        const pictures = new Map<string, Picture>();
        for (const state of posed) {
          this.part.value = done++ / (chosen.length * ids.length);
          const picture = await pictureInTurns(viewer, state, camera, side, stopped);
          if (stopped.aborted) return;
          if (!picture) {
            this.cancel();
            return;
          }
          pictures.set(state.method, picture);
        }
        const inOrder = methods.map((method) => pictures.get(method)!);
        this.drawn.value = new Map(this.drawn.peek()).set(row, inOrder);
      }
    } finally {
      for (const evaluator of evaluators) evaluator.dispose();
    }
    this.part.value = null;
  }
}

/** (pointCount) the squares of the largest distances of points from where the first puts them. */
function apartness([base, ...others]: readonly Evaluation[]): Float32Array {
  const { pointCount } = base!.rest;
  const apart = new Float32Array(pointCount);
  for (const other of others) {
    const { distances } = differenceOf(
      other.vertices().positions,
      base!.vertices().positions,
      pointCount,
    );
    distances.forEach((distance, point) => {
      apart[point] = Math.max(apart[point]!, distance * distance);
    });
  }
  return apart;
}
