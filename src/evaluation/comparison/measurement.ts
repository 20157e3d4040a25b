import { loadPart } from '../../core/failure.ts';
import { type Actor, skinInUse } from '../../document/scene.ts';
import type { KernelId, MethodId } from '../../skinning/method.ts';
import { WasmSkinning } from '../../skinning/wasm/wasm-skinning.ts';
import { EvaluationPool } from '../evaluation-pool.ts';
import { Kernels } from '../kernels.ts';
import { stressOf, type StressSuite } from './stress.ts';
import { stressPoses, type StressRanges } from './stress-poses.ts';
import { type Sweep, sweepOf } from './sweep.ts';
import type { TurnRange } from './turn-range.ts';

/** What is to be measured of methods, and what comes out. */
export interface MeasurementPlans {
  /** A joint over its range; see `sweepOf`. */
  readonly sweep: {
    readonly plan: { readonly range: TurnRange; readonly steps: number };
    readonly result: Sweep;
  };
  /** All joints at the ends of theirs; see `stressPoses` and `stressOf`. */
  readonly stress: {
    readonly plan: {
      /** (qCount) the pose from which joints turn. */
      readonly q: Float64Array;
      readonly ranges: StressRanges;
      /** The method from which differences are counted: an index of the methods. */
      readonly base: number;
    };
    readonly result: StressSuite;
  };
}

export type MeasurementKind = keyof MeasurementPlans;
export type MeasurementPlan<Kind extends MeasurementKind> = MeasurementPlans[Kind]['plan'];
export type MeasurementResult<Kind extends MeasurementKind> = MeasurementPlans[Kind]['result'];

/** All that a measurement needs; it can be passed to another thread. */
export interface MeasurementInput<Kind extends MeasurementKind = MeasurementKind> {
  readonly kind: Kind;
  readonly plan: MeasurementPlan<Kind>;
  /** Without a clip and pins, which would change the pose. */
  readonly actor: Actor;
  readonly methods: readonly MethodId[];
  /** The kernel of WebAssembly, which takes less time, or null. */
  readonly wasm: WebAssembly.Module | null;
  /** What methods have prepared for the actor's skin, by the method. */
  readonly prepared: ReadonlyMap<KernelId, unknown>;
}

/** The same without what can't be measured, such as pictures, which would be copied in vain. */
export function measurementInput<Kind extends MeasurementKind>(
  kind: Kind,
  plan: MeasurementPlan<Kind>,
  actor: Actor,
  methods: readonly MethodId[],
  kernels: Kernels,
): MeasurementInput<Kind> {
  const prepared = new Map<KernelId, unknown>();
  for (const method of methods) {
    const kernel = kernels.of(method);
    if (kernel?.prepare) prepared.set(method, kernels.extraOf(kernel, { ...actor, method }));
  }
  const wasm = kernels.wasm?.module ?? null;
  const bare = { ...actor.character, clips: [], materials: [], images: [] };
  return { kind, plan, actor: { ...actor, character: bare, clips: [] }, methods, wasm, prepared };
}

/** Measures with kernels and layers that it loads, and what was prepared. */
export async function measure<Kind extends MeasurementKind>(
  { kind, plan, actor, methods, wasm, prepared }: MeasurementInput<Kind>,
  onProgress: (part: number) => void,
): Promise<MeasurementResult<Kind>> {
  const { Preparations } = await loadPart(import('../preparations.ts'));
  const preparations = new Preparations({
    prepare: (method) => Promise.resolve(prepared.get(method.id)),
  });
  const kernels = new Kernels({ complete: () => Promise.resolve(preparations) });
  kernels.wasm = wasm && new WasmSkinning(wasm);
  for (const method of methods) await kernels.loadFor({ ...actor, method });
  const pool = new EvaluationPool(kernels);
  const works: { [Each in MeasurementKind]: (plan: MeasurementPlan<Each>) => Work<Each> } = {
    sweep: ({ range, steps }) => sweepOf(pool, actor, methods, range, steps),
    stress: ({ q, ranges, base }) => {
      const poses = stressPoses(actor.character, skinInUse(actor), q, ranges);
      return stressOf(pool, actor, methods, base, poses);
    },
  };
  const work: Work<Kind> = works[kind](plan);
  let told = -1;
  for (;;) {
    const step = work.next();
    if (step.done) return step.value;
    const part = Math.floor(step.value * toldParts) / toldParts;
    if (part > told) onProgress((told = part));
  }
}

type Work<Kind extends MeasurementKind> = Generator<number, MeasurementResult<Kind>>;

/** Progress is told in so many parts at most. */
const toldParts = 100;
