import type { ClipParts } from '../../core/motion/clip-parts.ts';
import type { Session } from '../../document/session.ts';
import { atFrame, framing, type TimeWindow } from './time-axis.ts';

/** What the timeline shows of a clip from left to right, in seconds: all of it until it is moved. */
export function shownWindow({ timeWindow }: Session, { start, end }: ClipParts): TimeWindow {
  return timeWindow.value ?? framing([start, end]);
}

/** A time in seconds, or the nearest frame's if times snap to frames. */
export function snapped({ snapsToFrames }: Session, { fps }: ClipParts, time: number): number {
  return snapsToFrames.value ? atFrame(time, fps) : time;
}
