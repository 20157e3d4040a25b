import type { Prepare } from '../evaluation/preparation.ts';
import { Preparations } from '../evaluation/preparations.ts';
import '../view/skinning-shaders.ts';
import { runTask } from './run-task.ts';

/** Weights that were changed are taken to stay as they are after so many milliseconds. */
const pauseTime = 300;

/** What methods prepare for skins, computed in workers. This module also brings their shaders. */
export function preparationsInWorkers(onFailed: (error: unknown) => void): Preparations {
  return new Preparations({ prepare: prepareInWorker, pause, onFailed });
}

const pause = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, pauseTime));

/** The worker gets copies of the mesh and the skin. */
const prepareInWorker: Prepare = (method, mesh, skin, { signal, onProgress }) =>
  runTask(
    'prepare-method',
    { method: method.id, mesh, skin },
    {
      signal,
      onProgress: (_, part) => onProgress(part),
      transfer: [],
    },
  );
