import type { Gpu } from '../gl/gpu.ts';

/** Learns what the view does, and decides the session's detail. */
export interface Pace {
  /** Something in the picture changed, other than its detail. */
  changed(): void;
  /** A picture was handed to the GPU; drawing began at this time, in milliseconds. */
  drawn(begin: number, gpu: Gpu): void;
}
