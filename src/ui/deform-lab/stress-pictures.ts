import { signal } from '@preact/signals-core';
import type { Actor } from '../../document/scene.ts';
import {
  type StressRow,
  type StressSuite,
  worstFirst,
} from '../../evaluation/comparison/stress.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import type { Picture } from '../../view/picture/encode-picture.ts';
import { pictureInTurns } from '../../view/picture/picture-in-turns.ts';
import { jointCamera } from '../../view/picture/joint-camera.ts';
import type { Camera } from '../../document/camera.ts';
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
    let done = 0;
    for (const row of chosen) {
      let camera: Camera | undefined;
      const pictures = new Map<string, Picture>();
      for (const method of ids) {
        this.part.value = done++ / (chosen.length * ids.length);
        const posed = { ...actor, method, q: row.pose.q };
        const cameraOf = (still: Evaluation): Camera => (camera ??= jointCamera(still, row.pose));
        const picture = viewer.available.value
          ? await pictureInTurns(viewer, posed, cameraOf, side, stopped)
          : null;
        if (stopped.aborted) return;
        if (!picture) {
          this.cancel();
          return;
        }
        pictures.set(method, picture);
      }
      const inOrder = methods.map((method) => pictures.get(method)!);
      this.drawn.value = new Map(this.drawn.peek()).set(row, inOrder);
    }
    this.part.value = null;
  }
}
