import { signal } from '@preact/signals-core';
import type { Diagnostic } from '../core/diagnostics.ts';

export type Shading = 'smooth' | 'faceted';
/** Where vertices are skinned. */
export type SkinDevice = 'gpu' | 'cpu';

/** What is neither saved nor undone: how the document is looked at. */
export class Session {
  readonly showSkin = signal(true);
  readonly showSkeleton = signal(false);
  readonly showAxes = signal(false);
  /** The skin lets the bones inside it show. */
  readonly translucent = signal(false);
  readonly shading = signal<Shading>('smooth');
  readonly skinDevice = signal<SkinDevice>('gpu');
  readonly selectedJoint = signal<number | null>(null);
  /** What the last files had to say. */
  readonly problems = signal<readonly Diagnostic[]>([]);
}
