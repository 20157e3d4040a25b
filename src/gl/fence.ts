import type { Gpu } from './gpu.ts';

/** Marks a place in the commands to the GPU. A later task can ask whether they are done so far. */
export class Fence {
  private readonly gl: WebGL2RenderingContext;
  private readonly sync: WebGLSync | null;

  constructor(gpu: Gpu) {
    const { gl } = gpu;
    this.gl = gl;
    this.sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Asks without waiting. A lost context has nothing left to do. The answer stays the same within a task. */
  get isDone(): boolean {
    const { gl, sync } = this;
    if (!sync || gl.isContextLost()) return true;
    return gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.SIGNALED;
  }

  dispose(): void {
    this.gl.deleteSync(this.sync);
  }
}

/** Resolves when the GPU has done everything that it was asked so far, or the context is lost. */
export async function gpuDone(gpu: Gpu): Promise<void> {
  const fence = new Fence(gpu);
  while (!fence.isDone) await nextTask();
  fence.dispose();
}

/** Resolves in a later task; timers would wait some milliseconds more. */
export function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
