/**
 * Resolves when the GPU has done everything that it was asked so far, or when the context is lost.
 * A fence is polled in later tasks, because browsers look at the GPU only between tasks; `finish`
 * does not wait in all of them.
 */
export async function gpuDone(gl: WebGL2RenderingContext): Promise<void> {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) return; // the context is lost
  gl.flush();
  while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await nextTask();
  gl.deleteSync(fence);
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
