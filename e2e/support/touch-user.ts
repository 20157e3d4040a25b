import type { Locator, Page } from '@playwright/test';
import type { Place } from './find-limb.ts';

/** A user with one finger. */
interface TouchUser {
  tap(target: Locator | Place): Promise<void>;
  stroke(from: Place, right: number, down: number): Promise<void>;
}

export async function touchUser(page: Page): Promise<TouchUser> {
  const client = await page.context().newCDPSession(page);
  return {
    tap: (target) => ('x' in target ? page.touchscreen.tap(target.x, target.y) : target.tap()),
    async stroke({ x, y }, right, down) {
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', part?: number) =>
        client.send('Input.dispatchTouchEvent', {
          type,
          touchPoints:
            part === undefined ? [] : [{ x: x + part * right, y: y + part * down, id: 0 }],
        });
      await touch('touchStart', 0);
      for (const part of [0.5, 1]) await touch('touchMove', part);
      await touch('touchEnd');
    },
  };
}
