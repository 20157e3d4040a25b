import type { ClipParts } from '../../../core/motion/clip-parts.ts';
import type { Session } from '../../../document/session.ts';
import { type TimeWindow, xOfTime } from '../../timeline/time-axis.ts';
import { timeText, timeUnit } from '../../timeline/timeline-state.ts';

interface PlayheadProperties {
  readonly session: Session;
  readonly clip: ClipParts;
  readonly timeWindow: TimeWindow;
  readonly width: number;
}

/** The line at the present time, through the ruler and every row. During playback it alone moves. */
export function Playhead({ session, clip, timeWindow, width }: PlayheadProperties) {
  const time = session.clipTime.value;
  const x = xOfTime(timeWindow, width, time);
  return (
    <div class="playhead" style={{ transform: `translateX(${x}px)` }} aria-hidden="true">
      <span>{timeText(time, clip.fps, timeUnit.value)}</span>
    </div>
  );
}
