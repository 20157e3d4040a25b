import { expect, test } from 'vitest';
import { Session } from '../../src/document/session.ts';
import { FramePace, type PaceClock } from '../../src/view/frame-pace.ts';

/** A clock whose time is set by the test; tasks run in order when their time comes. */
class FakeClock implements PaceClock {
  private time = 0;
  private tasks: { at: number; task: () => void }[] = [];

  now(): number {
    return this.time;
  }

  later(milliseconds: number, task: () => void): () => void {
    const entry = { at: this.time + milliseconds, task };
    this.tasks.push(entry);
    return () => (this.tasks = this.tasks.filter((each) => each !== entry));
  }

  pass(milliseconds: number): void {
    const end = this.time + milliseconds;
    for (;;) {
      const [next] = this.tasks.filter(({ at }) => at <= end).sort((a, b) => a.at - b.at);
      if (!next) break;
      this.tasks = this.tasks.filter((each) => each !== next);
      this.time = next.at;
      next.task();
    }
    this.time = end;
  }
}

function createPace() {
  const clock = new FakeClock();
  const session = new Session();
  const pace = new FramePace(session, clock);
  let fences = 0;
  /** A change whose picture is done after a time. */
  const picture = (milliseconds: number): void => {
    pace.changed();
    const begin = clock.now();
    fences++;
    pace.drawn(begin, {
      get isDone() {
        return clock.now() >= begin + milliseconds;
      },
      dispose: () => fences--,
    });
    clock.pass(milliseconds + 10);
  };
  return { clock, session, pace, picture, fencesLeft: () => fences };
}

test('two slow pictures in a row make drafts, and rest makes full pictures', () => {
  const { clock, session, pace, picture, fencesLeft } = createPace();
  picture(80);
  expect(session.detail.value).toBe('full');
  picture(80);
  expect(session.detail.value, 'nothing has moved since').toBe('full');
  for (let i = 0; i < 10; i++) {
    pace.changed();
    clock.pass(140);
    expect(session.detail.value).toBe('draft');
  }
  clock.pass(15);
  expect(session.detail.value).toBe('full');
  expect(fencesLeft()).toBe(0);
});

test('pictures that are fast, or slow now and then, stay full', () => {
  const { session, picture } = createPace();
  for (const milliseconds of [40, 80, 40, 80, 40, 40]) {
    picture(milliseconds);
    expect(session.detail.value).toBe('full');
  }
});

test('slow pictures of a view that rests stay full', () => {
  const { clock, session, picture } = createPace();
  for (let i = 0; i < 4; i++) {
    picture(400);
    clock.pass(200);
    expect(session.detail.value).toBe('full');
  }
});

test('a full picture after a rest needs two slow ones again to become a draft', () => {
  const { clock, session, pace, picture } = createPace();
  picture(80);
  picture(80);
  clock.pass(1000);
  picture(80);
  pace.changed();
  expect(session.detail.value).toBe('full');
  picture(80);
  pace.changed();
  expect(session.detail.value).toBe('draft');
});

test('a view that comes to rest with slow pictures never becomes a draft', () => {
  const { clock, session, pace, picture } = createPace();
  picture(80);
  picture(80);
  clock.pass(200);
  pace.changed();
  expect(session.detail.value).toBe('full');
});

test('one picture at a time is measured, and none of the others is forgotten', () => {
  const { clock, session, pace, fencesLeft } = createPace();
  let disposed = 0;
  const endless = { isDone: false, dispose: () => disposed++ };
  pace.drawn(clock.now(), endless);
  pace.drawn(clock.now(), endless);
  clock.pass(1000);
  expect(disposed).toBe(1);
  expect(session.detail.value).toBe('full');
  expect(fencesLeft()).toBe(0);
});
