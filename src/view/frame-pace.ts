import type { Session } from '../document/session.ts';
import { Fence } from '../gl/fence.ts';
import type { Pace } from './pace.ts';

/** A picture that was handed to the GPU. */
export interface PictureInWork {
  readonly isDone: boolean;
  dispose(): void;
}

/** The time in milliseconds, and tasks at later times. */
export interface PaceClock {
  now(): number;
  /** Returns a function that cancels the task. */
  later(milliseconds: number, task: () => void): () => void;
}

/** A picture that takes longer is slow, and so many of them in a row make drafts. */
const [slowMilliseconds, slowPictures] = [50, 2];
/** What has not changed for so long rests, and is drawn in full. */
const restMilliseconds = 150;
const pollMilliseconds = 4;

/**
 * Decides the session's detail by the time that pictures take. While something moves and pictures
 * are slow, they are drafts; when it rests, one more picture is drawn in full.
 */
export class FramePace {
  private readonly session: Session;
  private readonly clock: PaceClock;
  /** The time at which the last measured picture was done. */
  private doneAt = -Infinity;
  private slowInRow = 0;
  private measured: PictureInWork | null = null;
  private stopWaitingForRest = (): void => undefined;

  constructor(session: Session, clock: PaceClock) {
    this.session = session;
    this.clock = clock;
  }

  /** Something in the picture changed, other than its detail. */
  changed(): void {
    const { detail } = this.session;
    // Slow pictures alone make no draft: the view may have come to rest with them.
    const isSlow = this.slowInRow >= slowPictures;
    if (isSlow && this.clock.now() - this.doneAt <= restMilliseconds) {
      this.slowInRow = 0;
      detail.value = 'draft';
    }
    if (detail.peek() === 'draft') this.waitForRest();
  }

  /**
   * Measures a picture, unless an earlier one is still in work.
   *
   * @param begin the time at which drawing began
   */
  drawn(begin: number, picture: PictureInWork): void {
    if (this.measured || this.session.detail.peek() === 'draft') {
      picture.dispose();
      return;
    }
    // Nothing moves if the view rested before this picture.
    if (begin - this.doneAt > restMilliseconds) this.slowInRow = 0;
    this.measured = picture;
    this.poll(begin, picture);
  }

  private poll(begin: number, picture: PictureInWork): void {
    this.clock.later(pollMilliseconds, () => {
      if (!picture.isDone) {
        this.poll(begin, picture);
        return;
      }
      picture.dispose();
      this.measured = null;
      this.judge(this.clock.now() - begin);
    });
  }

  private judge(milliseconds: number): void {
    this.doneAt = this.clock.now();
    this.slowInRow = milliseconds > slowMilliseconds ? this.slowInRow + 1 : 0;
  }

  private waitForRest(): void {
    this.stopWaitingForRest();
    this.stopWaitingForRest = this.clock.later(restMilliseconds, () => {
      this.session.detail.value = 'full';
    });
  }
}

/** The pace of a page's view, by the page's clock and the GPU's fences. */
export function createPace(session: Session): Pace {
  const pace = new FramePace(session, pageClock);
  return {
    changed: () => {
      pace.changed();
    },
    drawn: (begin, gpu) => {
      pace.drawn(begin, new Fence(gpu));
    },
  };
}

const pageClock: PaceClock = {
  now: () => performance.now(),
  later(milliseconds, task) {
    const handle = setTimeout(task, milliseconds);
    return () => {
      clearTimeout(handle);
    };
  },
};
