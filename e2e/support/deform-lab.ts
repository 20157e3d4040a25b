import type { Locator, Page } from '@playwright/test';

/** What tests read and press of the deformation lab. */
interface Lab {
  readonly canvas: () => Locator;
  /** A pose that is offered over the view; the Deform tab offers them as well. */
  readonly offered: (name: string) => Locator;
  readonly mark: () => Locator;
  readonly wipe: () => Locator;
  readonly ring: () => Locator;
  /** A table of the vertex inspector. */
  readonly explained: (name: string) => Locator;
  /** What changes the comparison, over the view. */
  readonly change: (command: string) => Locator;
  readonly settled: () => Promise<void>;
  /** Presses a key in the view. */
  readonly press: (key: string) => Promise<void>;
}

/** The deformation lab of a page that tests share. */
export function deformLab(page: () => Page): Lab {
  const canvas = () => page().locator('canvas.scene');
  return {
    canvas,
    offered: (name) => page().locator('.comparison-foot').getByRole('button', { name }),
    mark: () => page().getByRole('button', { name: /^Largest difference of/ }),
    wipe: () => page().getByRole('slider', { name: /^Wipe between/ }),
    ring: () => page().locator('.worst-mark .ring'),
    explained: (name) => page().locator('.vertex-inspector').getByRole('region', { name }),
    change: (command) => page().locator(`.change-comparison [data-command="${command}"]`),
    settled: () => page().evaluate(() => window.sinew.settled()),
    async press(key) {
      await canvas().focus();
      await page().keyboard.press(key);
    },
  };
}

/** The middle of a box, from left to right. */
export const middleOf = ({ x, width }: { readonly x: number; readonly width: number }): number =>
  x + width / 2;

/** The size of pictures that are only compared with each other. */
export const small = { width: 320, height: 320 };
