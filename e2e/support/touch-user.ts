import type { Locator, Page } from '@playwright/test';
import type { Place } from './find-limb.ts';

/** A user with one finger, or two. */
interface TouchUser {
  /** Holds a finger still until something has come of it. */
  press(at: Place, until: () => Promise<unknown>): Promise<void>;
  /** Two fingers beside each other around a place, which go from one distance to another. */
  pinch(around: Place, from: number, to: number): Promise<void>;
  tap(target: Locator | Place): Promise<void>;
  stroke(from: Place, right: number, down: number): Promise<void>;
}

export async function touchUser(page: Page): Promise<TouchUser> {
  const client = await page.context().newCDPSession(page);
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly Place[]) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map((point, id) => ({ ...point, id })),
    });
  return {
    async press(at, until) {
      await send('touchStart', [at]);
      await until();
      await send('touchEnd', []);
    },
    async pinch({ x, y }, from, to) {
      const fingers = (apart: number): readonly Place[] => [
        { x: x - apart / 2, y },
        { x: x + apart / 2, y },
      ];
      await send('touchStart', fingers(from).slice(0, 1));
      await send('touchStart', fingers(from));
      for (const part of [0.5, 1]) await send('touchMove', fingers(from + part * (to - from)));
      await send('touchEnd', []);
    },
    tap: (target) => ('x' in target ? page.touchscreen.tap(target.x, target.y) : target.tap()),
    async stroke({ x, y }, right, down) {
      const at = (part: number): readonly Place[] => [{ x: x + part * right, y: y + part * down }];
      await send('touchStart', at(0));
      for (const part of [0.5, 1]) await send('touchMove', at(part));
      await send('touchEnd', []);
    },
  };
}
