import type { Evaluation } from '../evaluation/evaluation.ts';
import { gpuDone, nextTask } from '../gl/fence.ts';
import type { KernelId } from '../skinning/method.ts';
import { poseVertices } from '../skinning/pose-vertices.ts';
import type { KernelRow } from '../skinning/registry.ts';
import type { WasmSkinning } from '../skinning/wasm/wasm-skinning.ts';
import type { Viewer } from './viewer.ts';

/** The milliseconds that a method takes for all vertices of a character. */
export interface MethodTimes {
  readonly cpu: number;
  /** Null where the GPU does not compute the method. */
  readonly gpu: number | null;
}

/** A method is measured so often on the CPU, of which the median counts, and so often on the GPU at once. */
const [cpuRuns, gpuRuns] = [7, 16];

/**
 * Measures methods one after the other, and gives the page a turn between them.
 *
 * @returns nothing if the signal aborts it
 */
export async function measureTimes(
  viewer: Viewer,
  rows: readonly { readonly kernel: KernelRow; readonly evaluation: Evaluation }[],
  wasm: WasmSkinning | null,
  usesGpu: boolean,
  signal: AbortSignal,
): Promise<ReadonlyMap<KernelId, MethodTimes> | undefined> {
  const times = new Map<KernelId, MethodTimes>();
  for (const { kernel, evaluation } of rows) {
    await nextTask();
    if (signal.aborted) return undefined;
    const cpu = cpuTime(evaluation, wasm);
    const gpu = usesGpu && viewer.available.value ? await gpuTime(viewer, evaluation) : null;
    times.set(kernel.id, { cpu, gpu });
  }
  return signal.aborted ? undefined : times;
}

function cpuTime(evaluation: Evaluation, wasm: WasmSkinning | null): number {
  const { state, rest, skin, palette, method, use } = evaluation;
  const length = rest.vertexCount * 3;
  const out = { positions: new Float32Array(length), normals: new Float32Array(length) };
  const times = Array.from({ length: cpuRuns }, () => {
    const begin = performance.now();
    poseVertices(method, state.character.mesh, rest, skin, palette, use, out, wasm);
    return performance.now() - begin;
  });
  return times.sort((a, b) => a - b)[Math.floor(cpuRuns / 2)]!;
}

async function gpuTime(viewer: Viewer, evaluation: Evaluation): Promise<number | null> {
  const { method, palette, use } = evaluation;
  const renderer = viewer.present();
  const [view] = renderer.viewsOf([evaluation]);
  if (!view || method.finish) return null;
  view.skinned.skinOnGpu(method, palette, use);
  await gpuDone(renderer.gpu);
  const begin = performance.now();
  for (let run = 0; run < gpuRuns; run++) view.skinned.skinOnGpu(method, palette, use);
  // Work on the GPU empties the canvas until the next picture.
  viewer.requestFrame();
  await gpuDone(renderer.gpu);
  return (performance.now() - begin) / gpuRuns;
}
