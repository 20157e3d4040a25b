import { signal } from '@preact/signals-core';
import type { ActorId } from './scene.ts';
import type { Session } from './session.ts';

/** Copies of the selected character before and after the present moment of its clip. */
export interface GhostSettings {
  readonly isOn: boolean;
  /** How many there are on each side. */
  readonly before: number;
  readonly after: number;
  /** Whether they stand at keys or a number of frames apart. */
  readonly at: 'frames' | 'keys';
  readonly frames: number;
  /** How much fainter the farthest one is than the nearest, from 0 to 1. */
  readonly fade: number;
  /** Whether they are shown while the clip plays too. */
  readonly whilePlaying: boolean;
}

/** The paths that joints take. */
export interface TrailSettings {
  readonly isOn: boolean;
  /** The joint itself, or the end of its bone. */
  readonly point: 'joint' | 'end';
  /** How many frames on each side of the present moment are shown; null shows the whole clip. */
  readonly frames: number | null;
}

/** A joint whose trail is shown whatever is selected. */
export interface TrailJoint {
  readonly actorId: ActorId;
  readonly joint: number;
}

/** What the view shows of motion besides the present moment; a part of the session. */
export class MotionView {
  readonly ghosts = signal<GhostSettings>({
    isOn: false,
    before: 3,
    after: 3,
    at: 'frames',
    frames: 4,
    fade: 0.7,
    whilePlaying: false,
  });
  readonly trails = signal<TrailSettings>({ isOn: false, point: 'end', frames: null });
  readonly trailJoints = signal<readonly TrailJoint[]>([]);
}

/** Returns the session's view of motion, which is made when it is first needed. */
export function motionViewOf(session: Session): MotionView {
  let view = views.get(session);
  if (!view) views.set(session, (view = new MotionView()));
  return view;
}

const views = new WeakMap<Session, MotionView>();
