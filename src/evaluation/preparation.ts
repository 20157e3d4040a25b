import { type Signal, signal } from '@preact/signals-core';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import type { KernelId, SkinningMethod } from '../skinning/method.ts';

/** How a computation is followed and ended. */
export interface PrepareControl {
  /** When aborted, the result is no longer wanted. */
  readonly signal: AbortSignal;
  /** Gets the part that is done, from 0 to 1. */
  readonly onProgress: (part: number) => void;
}

/** Computes what a method prepares for a skin of a mesh. */
export type Prepare = (
  method: SkinningMethod,
  mesh: Mesh,
  skin: Skin,
  control: PrepareControl,
) => Promise<unknown>;

export const prepareInPlace: Prepare = async (method, mesh, skin, { onProgress }) =>
  Promise.resolve(method.prepare?.(mesh, skin, onProgress));

interface Listeners {
  /** Resolves when it may begin; it is asked when somebody wants a result. */
  readonly beforeStart: () => Promise<void>;
  readonly onStarted: (preparation: Preparation) => void;
  readonly onEnded: (preparation: Preparation, isThere: boolean) => void;
  readonly onArrived: (value: unknown) => void;
  readonly onFailed: ((error: unknown) => void) | undefined;
}

/**
 * What a method prepares for one skin. It is computed when it is first asked for, and no longer when
 * nobody whom it would interest is left, or somebody cancels it.
 */
export class Preparation {
  readonly method: KernelId;
  /** The part that is done, from 0 to 1. */
  readonly part = signal(0);
  /** What is shown in its place until it arrives: the last result for the same mesh, if there is one. */
  readonly standIn: unknown;
  private readonly arrived: Signal<unknown>;
  private readonly compute: (control: PrepareControl) => Promise<unknown>;
  private readonly listeners: Listeners;
  private computing: { readonly ended: Promise<void>; readonly control: AbortController } | null =
    null;
  /** Whether it failed or was canceled, so that it is not tried again for every picture. */
  private readonly isGivenUp = signal(false);

  constructor(
    method: KernelId,
    compute: (control: PrepareControl) => Promise<unknown>,
    standIn: unknown,
    listeners: Listeners,
  ) {
    this.method = method;
    this.standIn = standIn;
    this.compute = compute;
    this.listeners = listeners;
    this.arrived = signal<unknown>(undefined, { unwatched: () => this.leave() });
  }

  /** The result if it is there, else its stand-in. Reading subscribes, and begins to compute. */
  get value(): unknown {
    return this.isPending ? this.standIn : this.arrived.value;
  }

  /** Whether the result is on its way. Reading does the same. */
  get isPending(): boolean {
    const isPending = this.arrived.value === undefined && !this.isGivenUp.value;
    // onFailed reports the failure
    if (isPending) this.load().catch(() => undefined);
    return isPending;
  }

  /** Resolves when the result is there, or is no longer wanted. It rejects if it can't be computed. */
  load(): Promise<void> {
    if (this.arrived.peek() !== undefined) return Promise.resolve();
    if (!this.computing) {
      const control = new AbortController();
      this.computing = { ended: this.run(control), control };
    }
    return this.computing.ended;
  }

  /** Ends the computation; it begins again when somebody else asks who did not ask before. */
  cancel(): void {
    if (!this.computing) return;
    this.isGivenUp.value = true;
    this.abort();
  }

  private async run(control: AbortController): Promise<void> {
    // The caller may be an effect, which must not write signals that it reads.
    await Promise.resolve();
    await this.listeners.beforeStart();
    const isWanted = (): boolean => !control.signal.aborted;
    if (!isWanted()) return;
    this.part.value = 0;
    this.listeners.onStarted(this);
    try {
      const onProgress = (part: number): void => {
        if (isWanted()) this.part.value = part;
      };
      const value = await this.compute({ signal: control.signal, onProgress });
      if (!isWanted()) return;
      this.listeners.onArrived(value);
      this.arrived.value = value;
    } catch (error) {
      if (!isWanted()) return;
      this.isGivenUp.value = true;
      this.listeners.onFailed?.(error);
      throw error;
    } finally {
      if (isWanted()) this.listeners.onEnded(this, this.arrived.peek() !== undefined);
    }
  }

  private abort(): void {
    this.computing?.control.abort();
    this.computing = null;
    this.listeners.onEnded(this, false);
  }

  /** Nobody is left who would be told of the result. */
  private leave(): void {
    if (this.arrived.peek() !== undefined) return;
    this.isGivenUp.value = false;
    if (this.computing) this.abort();
  }
}
