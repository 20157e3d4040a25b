import { signal } from '@preact/signals-core';
import { linearBlend } from '../skinning/linear-blend.ts';
import type { KernelId, SkinningMethod } from '../skinning/method.ts';
import { kernelById } from '../skinning/registry.ts';
import type { WasmSkinning } from '../skinning/wasm/wasm-skinning.ts';

export interface KernelsOptions {
  /**
   * Prepares what else a kernel needs before it is used, for example the shader that computes the
   * same.
   */
  readonly prepare?: (kernel: SkinningMethod) => Promise<unknown>;
  /** This is called once for each kernel that can't be loaded. */
  readonly onFailed?: (error: unknown) => void;
}

/** The kernels that are loaded. Any other begins to load when it is first requested. */
export class Kernels {
  /**
   * Computes the same bits as the kernels in less time, from the moment it is set. Nothing that was
   * computed before changes.
   */
  wasm: WasmSkinning | null = null;
  private readonly ready = signal<ReadonlyMap<KernelId, SkinningMethod>>(
    new Map([[linearBlend.id, linearBlend]]),
  );
  private readonly loads = new Map<KernelId, Promise<void>>();
  private readonly failed = new Set<KernelId>();
  private readonly options: KernelsOptions;

  constructor(options: KernelsOptions = {}) {
    this.options = options;
  }

  /**
   * Returns the kernel if it is loaded. Reading subscribes: an effect that asked runs again when
   * the kernel arrives.
   */
  of(id: KernelId): SkinningMethod | undefined {
    const kernel = this.ready.value.get(id);
    if (!kernel) this.load(id).catch(() => undefined); // onFailed reports the failure
    return kernel;
  }

  /** Whether the kernel is still loading: it has not arrived, and loading has not failed. */
  isPending(id: KernelId): boolean {
    return !this.of(id) && !this.failed.has(id);
  }

  /**
   * Resolves when the kernel is loaded. It rejects if the kernel can't be loaded, without trying
   * again.
   */
  async load(id: KernelId): Promise<void> {
    if (this.ready.peek().has(id)) return;
    let load = this.loads.get(id);
    if (!load) {
      // A load that failed stays here, so that it is not tried again for every picture.
      this.loads.set(id, (load = this.fetch(id)));
      load.catch((error: unknown) => {
        this.failed.add(id);
        this.options.onFailed?.(error);
      });
    }
    await load;
  }

  /** Resolves when every kernel that was requested is loaded or has failed. */
  async settled(): Promise<void> {
    await Promise.allSettled(this.loads.values());
  }

  private async fetch(id: KernelId): Promise<void> {
    const kernel = await kernelById(id).load();
    await this.options.prepare?.(kernel);
    this.ready.value = new Map([...this.ready.peek(), [id, kernel]]);
  }
}
