import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { Progress } from '../ui/editor.ts';

/** Work that takes less time ends before anyone could read its progress. */
const patienceMilliseconds = 200;

/** Shows the progress of work once it has taken a moment. */
export class ProgressMeter {
  readonly shown: ReadonlySignal<Progress | null>;
  private readonly current = signal<Progress | null>(null);
  private latest: Progress | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private title = '';
  private jobs = 0;

  constructor() {
    this.shown = this.current;
  }

  /** Runs the work. If several run, the newest is shown. */
  async during<T>(title: string, work: () => Promise<T>): Promise<T> {
    const job = ++this.jobs;
    this.title = title;
    this.latest = { label: title, fraction: 0 };
    clearTimeout(this.timer);
    this.timer = setTimeout(() => (this.current.value = this.latest), patienceMilliseconds);
    try {
      return await work();
    } finally {
      if (job === this.jobs) this.clear();
    }
  }

  /** Reports the progress of the work; readers receive this function. */
  readonly report = (label: string, fraction: number): void => {
    this.latest = { label: `${this.title}: ${label}`, fraction };
    if (this.current.value) this.current.value = this.latest;
  };

  clear(): void {
    clearTimeout(this.timer);
    this.latest = null;
    this.current.value = null;
  }
}
