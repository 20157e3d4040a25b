import { effect } from '@preact/signals-core';
import type { Session } from '../document/session.ts';
import type { Transport } from '../document/transport.ts';

/** In seconds; a tab that was hidden does not jump ahead. */
const longestStep = 0.25;

/** Advances time while a clip plays, one step per picture, and never otherwise. */
export function runClock(session: Session, transport: Transport): void {
  let last = 0;
  let request = 0;
  const tick = (now: number): void => {
    request = 0;
    if (!session.playing.value) return;
    transport.pass(Math.min((now - last) / 1000, longestStep));
    last = now;
    request = requestAnimationFrame(tick);
  };
  effect(() => {
    if (!session.playing.value || request !== 0) return;
    last = performance.now();
    request = requestAnimationFrame(tick);
  });
}
