import { expect, type Page, test as playwrightTest } from '@playwright/test';
import type { Scripting } from '../../src/app/scripting.ts';
import { smallCharacters, type SmallFiles } from './small-characters.ts';

declare global {
  interface Window {
    sinew: Scripting;
    /** Whether the page opens bundled characters as they are, though it may be coarse, or small. */
    bundled?: 'whole' | 'small';
  }
}

/**
 * Playwright's `test`, whose coarse pages have one sample a pixel and small characters, whoever
 * opens them.
 */
const base = playwrightTest.extend({
  browser: [
    async ({ browser }, use) => {
      const create = browser.newContext.bind(browser);
      const small = smallCharacters();
      browser.newContext = async (options) => {
        const context = await create(options);
        await context.addInitScript(drawOneSample, true);
        await context.addInitScript(fetchSmall, small);
        return context;
      };
      await use(browser);
    },
    { scope: 'worker' },
  ],
});

/** Makes a page draw one sample a pixel from its next address on, though its view is not coarse. */
export async function drawPlainly(page: Page): Promise<void> {
  await page.addInitScript(drawOneSample, false);
}

/** Runs in the page, before the page's scripts. */
function drawOneSample(onlyCoarse: boolean): void {
  if (onlyCoarse && devicePixelRatio >= 1) return;
  const { prototype } = WebGL2RenderingContext;
  const name = 'renderbufferStorageMultisample';
  const store = Object.getOwnPropertyDescriptor(prototype, name)!
    .value as (typeof prototype)[typeof name];
  prototype[name] = function (target, _samples, ...format) {
    store.call(this, target, 0, ...format);
  };
}

/** Lets a page open the bundled characters as they are, or small, from its next address on. */
export async function openBundled(page: Page, kind: 'whole' | 'small'): Promise<void> {
  await page.addInitScript((kind) => (window.bundled = kind), kind);
}

/** Runs in the page, before the page's scripts. */
function fetchSmall(files: SmallFiles): void {
  const original = window.fetch;
  window.fetch = (...request) => {
    const [url] = request;
    const isSmall = (window.bundled ?? (devicePixelRatio < 1 ? 'small' : 'whole')) === 'small';
    const found =
      isSmall && url instanceof URL
        ? Object.entries(files).find(([name]) => url.pathname.endsWith(name))
        : undefined;
    if (!found) return original(...request);
    const bytes = Uint8Array.from(atob(found[1]), (letter) => letter.charCodeAt(0));
    return Promise.resolve(new Response(bytes));
  };
}

/**
 * Playwright's `test`, which checks in every spec that nothing is thrown or logged as an error, no
 * dialog opens, nothing is requested from another origin or sent to the page's own, and the content
 * security policy of the built page has nothing to refuse.
 */
export const test = base.extend({
  page: async ({ page, baseURL }, use) => {
    const broken = await brokenPromises(page, baseURL);
    await use(page);
    expect(broken, 'errors, dialogs and requests that the page must not make').toEqual([]);
  },
});

/**
 * Playwright's `test` for failures outside of Sinew, which must end in a message: it checks only that
 * nothing is thrown, because the browser logs what it could not load.
 */
export const failureTest = base.extend({
  page: async ({ page }, use) => {
    const thrown: string[] = [];
    page.on('pageerror', (error) => thrown.push(error.stack ?? error.message));
    await use(page);
    expect(thrown).toEqual([]);
  },
});

/**
 * The view has a quarter of its pixels, with one sample each, and bundled characters have a tenth of
 * their triangles. It is for tests of what a user can do, in which the drawing would take most of
 * the time.
 */
export const coarse = { deviceScaleFactor: 0.5 } as const;

/** A page that the tests of a file use one after the other, with the same checks. */
export function sharedPage(prepare: (page: Page) => Promise<void>): () => Page {
  let page: Page | undefined;
  let broken: readonly string[] = [];
  test.describe.configure({ mode: 'default' });
  test.beforeAll(async ({ browser, baseURL }) => {
    // The context is created explicitly, because tools that inspect the page reject the one that
    // newPage creates.
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

/** Collects what the page did but must not; the list grows while the page is used. */
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

/**
 * Turns each violation of the page's content security policy into an uncaught error of the page
 * from now on.
 */
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
