import { type Browser, chromium } from '@playwright/test';
import { browserFlags, findBrowser } from '../../tools/browser.mjs';

/** Starts the browser of the tests. */
export async function launchBrowser(): Promise<Browser> {
  const { path } = findBrowser();
  return chromium.launch({
    ...(path !== undefined && { executablePath: path }),
    chromiumSandbox: false,
    args: browserFlags,
  });
}
