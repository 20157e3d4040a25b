import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { Actor } from '../../document/scene.ts';
import { createActor } from '../../document/scene.ts';
import {
  measurementInput,
  type MeasurementKind,
  type MeasurementPlan,
  type MeasurementResult,
} from '../../evaluation/comparison/measurement.ts';
import type { MethodId } from '../../skinning/method.ts';
import { methods } from '../../skinning/registry.ts';
import { failureText } from '../attempt.ts';
import type { Actions, Looking, Telling } from '../editor.ts';

type MeasuringEditor = Looking & Telling & Pick<Actions, 'measure'>;

/** No actor of a scene has it. */
const measuredId = -2;

/** How far a measurement is, and with what it waits. */
export interface Progress {
  readonly text: string;
  /** From 0 to 1, or null while it can't be told. */
  readonly part: number | null;
}

/**
 * Measures what methods do to the selected character, in its present pose or from it, while the page
 * goes on. Only the last measurement counts.
 */
export class Measurement<T> {
  private readonly editor: MeasuringEditor;
  private readonly state = signal<Progress | null>(null);
  private readonly found = signal<T | null>(null);
  private stop = new AbortController();

  constructor(editor: MeasuringEditor) {
    this.editor = editor;
  }

  /** Null while nothing is measured. */
  get progress(): ReadonlySignal<Progress | null> {
    return this.state;
  }

  /** The last result. */
  get result(): ReadonlySignal<T | null> {
    return this.found;
  }

  cancel(): void {
    this.stop.abort();
    this.state.value = null;
  }

  /**
   * Starts in place of what is being measured.
   *
   * @param planOf what is measured, of the character as it is measured
   * @param complete adds to a result what belongs to it
   */
  async start<Kind extends MeasurementKind>(
    kind: Kind,
    actor: Actor,
    ids: readonly MethodId[],
    planOf: (plain: Actor) => MeasurementPlan<Kind>,
    complete: (result: MeasurementResult<Kind>, plain: Actor) => T,
  ): Promise<void> {
    this.cancel();
    const { signal: stopped } = (this.stop = new AbortController());
    const { evaluations, notice } = this.editor;
    const { kernels } = evaluations.pool;
    const plain = plainActor(actor, evaluations.of(actor).snapshot());
    try {
      for (const method of ids) {
        const { label } = methods.find(({ id }) => id === method)!;
        this.state.value = { text: `Preparing ${label}`, part: null };
        await Promise.race([kernels.loadFor({ ...plain, method }), aborted(stopped)]);
        if (stopped.aborted) return;
      }
      const onProgress = (part: number): void => {
        if (!stopped.aborted) this.state.value = { text: 'Measuring', part };
      };
      onProgress(0);
      const input = measurementInput(kind, planOf(plain), plain, ids, kernels);
      const result = await this.editor.measure(input, { signal: stopped, onProgress });
      if (result === undefined || stopped.aborted) return;
      this.found.value = complete(result, plain);
      this.state.value = null;
    } catch (error) {
      if (stopped.aborted) return;
      this.state.value = null;
      notice.value = failureText(error);
    }
  }
}

/** The character in a pose without what would change that: clips and pins. */
function plainActor(
  { character, method, methodSettings, normalizeWeights, influences, skin, look }: Actor,
  pose: Pick<Actor, 'q' | 'morphWeights'>,
): Actor {
  const kept = { ...pose, methodSettings, normalizeWeights, influences, skin, look };
  return createActor(measuredId, character, method, kept);
}

function aborted(stopped: AbortSignal): Promise<void> {
  return new Promise((resolve) => stopped.addEventListener('abort', () => resolve()));
}
