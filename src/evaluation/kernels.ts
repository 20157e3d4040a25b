import { signal } from '@preact/signals-core';
import { loadPart } from '../core/failure.ts';
import { type Actor, skinInUse } from '../document/scene.ts';
import { poseLayers } from '../posing/layers.ts';
import type { LayerFunction, PoseLayer } from '../posing/pose-layer.ts';
import { linearBlend } from '../skinning/linear-blend.ts';
import type { KernelId, SkinningMethod } from '../skinning/method.ts';
import { kernelById, kernelOf, recomputedNormals } from '../skinning/registry.ts';
import type { WasmSkinning } from '../skinning/wasm/wasm-skinning.ts';
import type { recomputeNormals } from '../skinning/welded-normals.ts';
import type { followedJoints } from './followed-joints.ts';
import { LazyPart } from './lazy-part.ts';
import type { Preparation } from './preparation.ts';
import type { Preparations } from './preparations.ts';

export interface KernelsOptions {
  /**
   * Loads what else a kernel needs before it is used, for example the shader that computes the
   * same, and returns how kernels prepare for skins; in place, if there is nothing.
   */
  readonly complete?: (kernel: SkinningMethod) => Promise<Preparations | undefined>;
  /** This is called once for each part that can't be loaded. */
  readonly onFailed?: (error: unknown) => void;
}

/** The kernels that are loaded. Any other begins to load when it is first requested. */
export class Kernels {
  /**
   * Computes the same bits as the kernels in less time, from the moment it is set. Nothing that was
   * computed before changes.
   */
  wasm: WasmSkinning | null = null;
  /** Recomputes normals from posed faces. */
  readonly recompute: LazyPart<typeof recomputeNormals>;
  /** By a name, the kernel's id or the layer. */
  private readonly parts = new Map<unknown, LazyPart<unknown>>();
  /** What kernels prepare for skins, from the moment that a kernel is loaded which does. */
  readonly preparations = signal<Preparations | null>(null);
  private readonly options: KernelsOptions;

  constructor(options: KernelsOptions = {}) {
    this.options = options;
    this.recompute = new LazyPart(
      async () => (await loadPart(import('../skinning/welded-normals.ts'))).recomputeNormals,
      options.onFailed,
    );
  }

  /**
   * Returns the kernel if it is loaded. Reading subscribes: an effect that asked runs again when
   * the kernel arrives.
   */
  of(id: KernelId): SkinningMethod | undefined {
    return id === linearBlend.id ? linearBlend : this.kernel(id).value;
  }

  /** Returns the kernel of an actor if it is loaded and what it prepares for the skin is there. */
  readyFor(actor: Actor): SkinningMethod | undefined {
    const kernel = this.of(kernelOf(actor).id);
    return kernel && (!kernel.prepare || this.extraOf(kernel, actor)) ? kernel : undefined;
  }

  /** What a kernel prepared for the skin of an actor, if it did. */
  extraOf(kernel: SkinningMethod, actor: Actor): unknown {
    return kernel.prepare && this.preparation(kernel, actor).value;
  }

  /** What an actor's kernel waits for, as labels for the user. */
  pendingFor(actor: Actor): readonly string[] {
    const { id, label } = kernelOf(actor);
    const kernel = this.of(id);
    const waits = kernel
      ? kernel.prepare && this.preparation(kernel, actor).isPending
      : this.kernel(id).isPending;
    return waits ? [label] : [];
  }

  /**
   * Resolves when the kernel is loaded. It rejects if the kernel can't be loaded, without trying
   * again.
   */
  async load(id: KernelId): Promise<void> {
    if (id !== linearBlend.id) await this.kernel(id).load();
  }

  /** Does the same for all that an actor needs. */
  async loadFor(actor: Actor): Promise<void> {
    const { id } = kernelOf(actor);
    await this.load(id);
    const kernel = this.of(id);
    if (kernel?.prepare) await this.preparation(kernel, actor).load();
    if (recomputedNormals(actor.normals)) await this.recompute.load();
    for (const layer of poseLayers) if (layer.isActive(actor)) await this.layer(layer).load();
    if (actor.pins.some(({ follows }) => follows)) await this.followed.load();
  }

  /** Finds what pins follow of other characters. */
  get followed(): LazyPart<typeof followedJoints> {
    return this.part('followed', async () => {
      return (await loadPart(import('./followed-joints.ts'))).followedJoints;
    });
  }

  /** The function of a layer. */
  layer(layer: PoseLayer): LazyPart<LayerFunction> {
    return this.part(layer, () => layer.load());
  }

  /** Resolves when every part that was requested is loaded or has failed. */
  async settled(): Promise<void> {
    await Promise.allSettled([...this.parts.values()].map((part) => part.load()));
  }

  private kernel(id: KernelId): LazyPart<SkinningMethod> {
    return this.part(id, async () => {
      const kernel = await kernelById(id).load();
      const given = await this.options.complete?.(kernel);
      if (kernel.prepare) {
        this.preparations.value ??=
          given ?? new (await loadPart(import('./preparations.ts'))).Preparations();
      }
      return kernel;
    });
  }

  private preparation(kernel: SkinningMethod, actor: Actor): Preparation {
    return this.preparations.value!.of(kernel, actor.character.mesh, skinInUse(actor));
  }

  private part<T>(key: unknown, fetch: () => Promise<T>): LazyPart<T> {
    let part = this.parts.get(key);
    if (!part) this.parts.set(key, (part = new LazyPart(fetch, this.options.onFailed)));
    return part as LazyPart<T>;
  }
}
