import { signal } from '@preact/signals-core';
import { linearBlend } from '../skinning/linear-blend.ts';
import type { KernelId, SkinningMethod } from '../skinning/method.ts';
import { kernelById } from '../skinning/registry.ts';

export interface KernelsOptions {
  /** What else a kernel needs before it is used: the shader that computes the same, say. */
  readonly prepare?: (kernel: SkinningMethod) => Promise<unknown>;
  /** Told once of a kernel that can't be loaded. */
  readonly onFailed?: (error: unknown) => void;
}

/** The kernels that are there. One that is not begins to load when it is first asked for. */
export class Kernels {
  private readonly ready = signal<ReadonlyMap<KernelId, SkinningMethod>>(
    new Map([[linearBlend.id, linearBlend]]),
  );
  private readonly loads = new Map<KernelId, Promise<void>>();
  private readonly failed = new Set<KernelId>();
  private readonly options: KernelsOptions;

  constructor(options: KernelsOptions = {}) {
    this.options = options;
  }

  /** The kernel, if it is there. To ask follows: whoever asked in an effect is told when it comes. */
  of(id: KernelId): SkinningMethod | undefined {
    const kernel = this.ready.value.get(id);
    if (!kernel) this.load(id).catch(() => undefined); // which onFailed was told
    return kernel;
  }

  /** Whether the kernel will come: it is not there yet, and nothing has kept it from coming. */
  isPending(id: KernelId): boolean {
    return !this.of(id) && !this.failed.has(id);
  }

  /** Resolves when the kernel is there; rejects if it can't be loaded, without trying again. */
  async load(id: KernelId): Promise<void> {
    if (this.ready.peek().has(id)) return;
    let load = this.loads.get(id);
    if (!load) {
      // One that failed stays here, so that it is not tried at each picture again.
      this.loads.set(id, (load = this.fetch(id)));
      load.catch((error: unknown) => {
        this.failed.add(id);
        this.options.onFailed?.(error);
      });
    }
    await load;
  }

  /** Resolves when every kernel that was asked for is there or can't be loaded. */
  async settled(): Promise<void> {
    await Promise.allSettled(this.loads.values());
  }

  private async fetch(id: KernelId): Promise<void> {
    const kernel = await kernelById(id).load();
    await this.options.prepare?.(kernel);
    this.ready.value = new Map([...this.ready.peek(), [id, kernel]]);
  }
}
