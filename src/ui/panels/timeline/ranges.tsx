import type { ClipParts } from '../../../core/motion/clip-parts.ts';
import type { Session } from '../../../document/session.ts';
import { type TimeWindow, xOfTime } from '../../timeline/time-axis.ts';

interface RangesProperties {
  readonly session: Session;
  readonly clip: ClipParts;
  readonly timeWindow: TimeWindow;
  readonly width: number;
}

/** Behind ruler and rows: shade outside of the clip, and a lighter band where it plays. */
export function Ranges({ session, clip, timeWindow, width }: RangesProperties) {
  const across = (time: number): number =>
    Math.min(Math.max(xOfTime(timeWindow, width, time), 0), width);
  const [start, end] = [across(clip.start), across(clip.end)];
  const work = session.workRange.value;
  const [from, to] = work ? [across(work[0]), across(work[1])] : [0, 0];
  return (
    <div class="ranges" aria-hidden="true">
      <div class="outside" style={{ left: 0, width: `${start}px` }} />
      <div class="outside" style={{ left: `${end}px`, right: 0 }} />
      {work && <div class="work" style={{ left: `${from}px`, width: `${to - from}px` }} />}
    </div>
  );
}
