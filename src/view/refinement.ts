import { loadPart } from '../core/failure.ts';
import { LazyPart } from '../evaluation/lazy-part.ts';

/**
 * What every picture after the first has: the shadow where feet touch the floor, and triangles in
 * an order that leaves out the inner sides of closed surfaces, which is faster and looks the same.
 * The page loads it when the first picture was shown.
 */
export const refinement = new LazyPart(async () => loadPart(import('./refined.ts')));
