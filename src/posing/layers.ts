import { loadPart } from '../core/failure.ts';
import type { PoseLayer } from './pose-layer.ts';

/** Every pose layer, in the order of application. */
export const poseLayers: readonly PoseLayer[] = [
  {
    label: 'Clip',
    isActive: ({ clip }) => clip !== null,
    load: async () => (await loadPart(import('./clip-layer.ts'))).applyClip,
  },
  {
    label: 'Pins',
    isActive: ({ pins }) => pins.length > 0,
    load: async () => (await loadPart(import('./pins/pin-layer.ts'))).applyPins,
  },
  {
    label: 'Linked rotations',
    isShownOnly: true,
    isActive: ({ character }) => character.rotationLinks.length > 0,
    load: async () => (await loadPart(import('./rotation-links.ts'))).applyRotationLinks,
  },
];
