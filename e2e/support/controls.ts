import type { Locator, Page } from '@playwright/test';
import { controlRow } from './app.ts';

/** A folder of the controls; lights and camera have rows with the same names. */
function folder(page: Page, title: string): Locator {
  return page.locator(`.controls .lil-gui:has(> .lil-title:text-is("${title}"))`);
}

/** The camera as its folder shows it, in degrees and scene units. */
export async function cameraOf(page: Page) {
  const value = async (row: string): Promise<number> =>
    Number(await controlRow(folder(page, 'Camera'), row).locator('input').inputValue());
  return {
    azimuth: await value('Azimuth °'),
    elevation: await value('Elevation °'),
    distance: await value('Distance'),
  };
}

/** What is drawn, as the View folder shows it. */
export async function drawnOf(page: Page): Promise<string[]> {
  const drawn: string[] = [];
  for (const row of ['Skin', 'Skeleton', 'Axes']) {
    if (await controlRow(folder(page, 'View'), row).getByRole('checkbox').isChecked())
      drawn.push(row);
  }
  return drawn;
}

/** Types a number into the row with this name for screen readers, even if it is out of sight. */
export async function typeNumber(page: Page, name: string, value: number): Promise<void> {
  await page.locator(`input[aria-label="${name}"]`).evaluate((field: HTMLInputElement, text) => {
    field.value = text;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    field.dispatchEvent(new Event('blur'));
  }, `${value}`);
}
