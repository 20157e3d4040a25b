import { signal } from '@preact/signals-core';

/** A part of the program that begins to load when it is first requested. */
export class LazyPart<T> {
  private readonly arrived = signal<T | undefined>(undefined);
  private readonly fetch: () => Promise<T>;
  private readonly onFailed: ((error: unknown) => void) | undefined;
  private loading: Promise<void> | undefined;
  private failed = false;

  /** @param onFailed is called once if the part can't be loaded */
  constructor(fetch: () => Promise<T>, onFailed?: (error: unknown) => void) {
    this.fetch = fetch;
    this.onFailed = onFailed;
  }

  /**
   * The part if it is loaded. Reading subscribes: an effect that asked runs again when the part
   * arrives.
   */
  get value(): T | undefined {
    const part = this.arrived.value;
    if (!part) this.load().catch(() => undefined); // onFailed reports the failure
    return part;
  }

  /** The part if it is loaded, without a request for it. Reading subscribes. */
  get loaded(): T | undefined {
    return this.arrived.value;
  }

  /** Whether the part is still loading: it has not arrived, and loading has not failed. */
  get isPending(): boolean {
    return !this.value && !this.failed;
  }

  /**
   * Resolves when the part is loaded. It rejects if the part can't be loaded, without trying again.
   */
  load(): Promise<void> {
    // A load that failed stays here, so that it is not tried again for every picture.
    if (!this.loading) {
      this.loading = this.fetch().then((part) => void (this.arrived.value = part));
      this.loading.catch((error: unknown) => {
        this.failed = true;
        this.onFailed?.(error);
      });
    }
    return this.loading;
  }
}
