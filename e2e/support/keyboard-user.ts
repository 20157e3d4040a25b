import { expect, type Page } from '@playwright/test';

/** A user who has a keyboard alone. */
interface KeyboardUser {
  /** Finds a command or a thing in the palette and runs it. */
  command(words: string): Promise<void>;
  /** Steps with Tab until what has this name has the focus. */
  tabTo(label: string): Promise<void>;
}

/** More steps than this are too many for anybody. */
const mostSteps = 40;

export function keyboardUser(page: Page): KeyboardUser {
  const { keyboard } = page;
  /** The name of what has the focus: its label, or else its text. */
  const focused = () =>
    page.evaluate(() => {
      const element = document.activeElement;
      return element?.getAttribute('aria-label') ?? element?.textContent.trim();
    });
  return {
    async command(words) {
      await keyboard.press('ControlOrMeta+k');
      await expect(page.getByRole('combobox', { name: 'Search the commands' })).toBeFocused();
      // The palette searches after every letter, which its own test tries.
      await keyboard.insertText(words);
      await expect(page.getByRole('dialog').getByRole('option', { selected: true })).toContainText(
        words,
      );
      await keyboard.press('Enter');
    },
    async tabTo(label) {
      for (let count = 0; (await focused()) !== label; count++) {
        expect(count, `steps to ${label}`).toBeLessThan(mostSteps);
        await keyboard.press('Tab');
      }
    },
  };
}
