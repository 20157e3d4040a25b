import { writeFileSync } from 'node:fs';
import type { Locator, Page } from '@playwright/test';
import type { NamedFile } from './app.ts';
import type { Place } from './find-limb.ts';
import { test } from './test.ts';

/** A user with a mouse who counts presses; a drag, a drop and a typed value are one press each. */
interface CountedUser {
  readonly presses: number;
  click(target: Locator | Place): Promise<void>;
  drag(from: Place, right: number, down: number): Promise<void>;
  /** Opens a menu and chooses from it: two presses. */
  choose(menu: Locator, option: string): Promise<void>;
  /** Replaces the value of a field. */
  type(field: Locator, value: string): Promise<void>;
  /** Drops files from the disk, as from a window of the system. */
  drop(files: readonly NamedFile[], at: Place): Promise<void>;
}

export function countedUser(page: Page): CountedUser {
  const { mouse, keyboard } = page;
  let presses = 0;
  /** Presses the button at the middle of what the window shows of a target. */
  const click = async (target: Locator | Place): Promise<void> => {
    if ('x' in target) await mouse.click(target.x, target.y);
    else await target.click();
  };
  return {
    get presses() {
      return presses;
    },
    async click(target) {
      presses++;
      await click(target);
    },
    async drag({ x, y }, right, down) {
      presses++;
      await mouse.move(x, y);
      await mouse.down();
      await mouse.move(x + right / 2, y + down / 2);
      await mouse.move(x + right, y + down);
      await mouse.up();
    },
    async choose(menu, option) {
      presses += 2;
      await menu.selectOption({ label: option });
    },
    async type(field, value) {
      presses++;
      await click(field);
      await keyboard.press('ControlOrMeta+a');
      await keyboard.type(value);
      await keyboard.press('Enter');
    },
    async drop(files, { x, y }) {
      presses++;
      const paths = files.map(({ name, content }) => {
        const file = test.info().outputPath(name);
        writeFileSync(file, content);
        return file;
      });
      const client = await page.context().newCDPSession(page);
      const data = { items: [], files: paths, dragOperationsMask: 1 };
      for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
        await client.send('Input.dispatchDragEvent', { type, x, y, data });
      }
    },
  };
}
