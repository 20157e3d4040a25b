import { test as base, expect, type Page } from '@playwright/test';
import type { Scripting } from '../../src/app/scripting.ts';

declare global {
  interface Window {
    sinew: Scripting;
  }
}

/**
 * Playwright's `test` with a promise kept in every spec: nothing is thrown or logged as an error, no
 * dialog opens, nothing is asked of any other origin, or sent to the page's own, and the content
 * security policy of the built page has nothing to refuse.
 */
export const test = base.extend({
  page: async ({ page, baseURL }, use) => {
    const broken = await brokenPromises(page, baseURL);
    await use(page);
    expect(broken, 'errors, dialogs and requests that the page must not make').toEqual([]);
  },
});

/** A page that the tests of a file use one after the other, with the promise kept as well. */
export function sharedPage(prepare: (page: Page) => Promise<void>): () => Page {
  let page: Page | undefined;
  let broken: readonly string[] = [];
  test.describe.configure({ mode: 'default' });
  test.beforeAll(async ({ browser, baseURL }) => {
    // A context by hand: tools that look into the page refuse the one that newPage makes.
    page = await (await browser.newContext()).newPage();
    broken = await brokenPromises(page, baseURL);
    await prepare(page);
  });
  test.afterEach(() => expect(broken).toEqual([]));
  test.afterAll(() => page?.context().close());
  return () => {
    if (!page) throw new Error('the shared page is there in tests alone');
    return page;
  };
}

/** What the page did that it must not; the list grows as the page goes on. */
async function brokenPromises(page: Page, baseURL: string | undefined): Promise<readonly string[]> {
  const broken: string[] = [];
  const origin = new URL(baseURL!).origin;
  page.on('pageerror', (error) => broken.push(`thrown: ${error.stack ?? error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') broken.push(`console: ${message.text()}`);
  });
  page.on('dialog', (dialog) => {
    broken.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on('request', (request) => {
    const url = request.url();
    if (!new RegExp(`^(?:${origin}/|blob:|data:|about:)`).test(url)) broken.push(`asked: ${url}`);
    if (request.method() !== 'GET' || request.postData() !== null) broken.push(`sent to: ${url}`);
  });
  await watchPolicy(page);
  return broken;
}

/** From now on what the page's content security policy refuses is an uncaught error of the page. */
export async function watchPolicy(page: Page): Promise<void> {
  await page.addInitScript(() => {
    addEventListener(
      'securitypolicyviolation',
      ({ effectiveDirective, blockedURI, sourceFile }) => {
        reportError(new Error(`refused by ${effectiveDirective}: ${blockedURI} of ${sourceFile}`));
      },
    );
  });
}
