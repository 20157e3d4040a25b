import { gpuDone } from '../../gl/fence.ts';
import type { Gpu } from '../../gl/gpu.ts';

/** The times of frames of one kind, in milliseconds. */
export interface FrameTimes {
  readonly median: number;
  readonly least: number;
  /** In the order in which they were taken. */
  readonly all: readonly number[];
}

/** Enough for a median on a fast machine. A slow one stops earlier. */
const mostFrames = 60;
const leastFrames = 3;
const enoughMilliseconds = 1500;

/**
 * Times frames, from the change that causes one until the GPU has drawn it. The first one is not
 * counted, because drivers compile programs when they are first used.
 *
 * @param draw changes the scene or the camera and draws the picture; it gets the frame's number
 */
export async function timeFrames(
  gpu: Gpu,
  draw: (frame: number) => void,
  signal: AbortSignal,
): Promise<FrameTimes> {
  const all: number[] = [];
  let total = 0;
  for (let frame = 0; frame <= mostFrames; frame++) {
    signal.throwIfAborted();
    const begin = performance.now();
    draw(frame);
    await gpuDone(gpu);
    if (frame === 0) continue;
    const time = performance.now() - begin;
    all.push(time);
    total += time;
    if (total > enoughMilliseconds && all.length >= leastFrames) break;
  }
  const sorted = [...all].sort((a, b) => a - b);
  return { median: sorted[sorted.length >> 1]!, least: sorted[0]!, all };
}
