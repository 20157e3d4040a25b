import type { Pass, PassId } from './pass.ts';
import type { Viewer } from './viewer.ts';

/** Adds a pass whose code came later, in front of another one in the order of drawing. */
export function addPassBefore({ passes }: Viewer, id: PassId, added: Pass): void {
  passes.value = passes.value.flatMap((pass) => (pass.id === id ? [added, pass] : [pass]));
}
