import { signal } from '@preact/signals-core';
import type { Session } from '../../document/session.ts';
import type { PlaneDirection } from '../../evaluation/comparison/cutting-plane.ts';
import type { MethodId } from '../../skinning/method.ts';
import type { Figure, FigureView } from './figure-paths.ts';

/** The cutting figure and how it is shown; like the session, this is neither saved nor undone. */
class CuttingSettings {
  readonly isOpen = signal(false);
  readonly direction = signal<PlaneDirection>('along');
  /** In radians; see `PlanePlace`. */
  readonly turn = signal(0);
  /** As a part of the plane's reach. */
  readonly offset = signal(0);
  /** The method beside rigid parts and linear blend. */
  readonly third = signal<MethodId>('dual-quaternion');
  /** What is shown; null while there is nothing to cut, or the figure is closed. */
  readonly figure = signal<Figure | null>(null);
  /** The part of it that the drawing shows; null is the surroundings of the joint. */
  readonly view = signal<FigureView | null>(null);
}

const known = new WeakMap<Session, CuttingSettings>();

export function cuttingSettings(session: Session): CuttingSettings {
  let settings = known.get(session);
  if (!settings) known.set(session, (settings = new CuttingSettings()));
  return settings;
}
