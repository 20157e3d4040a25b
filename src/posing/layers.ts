import { clipLayer } from './clip-layer.ts';
import type { PoseLayer } from './pose-layer.ts';

/** Every pose layer, in the order of application. */
export const poseLayers: readonly PoseLayer[] = [clipLayer];
