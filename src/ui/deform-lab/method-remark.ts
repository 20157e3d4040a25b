import type { Evaluation } from '../../evaluation/evaluation.ts';
import type { KernelRow } from '../../skinning/registry.ts';

/** What stands behind the name of a method while linear blend is shown in its place, or nothing. */
export function remarkOn(kernel: KernelRow, { pending, method }: Evaluation): string {
  if (pending.length > 0) return ' (preparing; linear blend meanwhile)';
  return method.id === kernel.id ? '' : ' (not available; linear blend instead)';
}
