import { expect, type Page } from '@playwright/test';
import { openApp } from './support/app.ts';
import { coarse, test, watchPolicy } from './support/test.ts';

// These tests check the content security policy of the built page. Every other spec checks that the
// page itself violates nothing.
test.use({ ...coarse, viewport: { width: 960, height: 420 } });

declare global {
  interface Window {
    /** What the planted scripts managed to run. */
    ran: string[];
  }
}

/** Collects the page's messages about refused content. */
function refusals(page: Page): string[] {
  const told: string[] = [];
  page.on('pageerror', ({ message }) => {
    const directive = /^refused by ([\w-]+): (\S+)/.exec(message);
    if (directive) told.push(`${directive[1]} ${directive[2]}`);
  });
  return told;
}

test('scripts, markup and styles that are planted in the page do nothing', async ({ browser }) => {
  // This page comes from the browser directly, because the page of the fixture fails the test when
  // anything is refused.
  const page = await browser.newPage();
  const told = refusals(page);
  await watchPolicy(page);
  await page.route(/\/(\?.*)?$/, async (route) => {
    const response = await route.fetch();
    const body = (await response.text()).replace(
      '<body>',
      `<body onload="ran.push('handler')"><script>ran.push('inline')</script>
       <style>body { opacity: 0.5 }</style>`,
    );
    await route.fulfill({ response, body });
  });
  await page.addInitScript(() => (window.ran = []));
  await openApp(page);
  const outcome = await page.evaluate(async () => {
    const failure = (act: () => unknown): string => {
      try {
        act();
        return 'nothing';
      } catch (error) {
        return (error as Error).name;
      }
    };
    const { trustedTypes } = window as unknown as {
      trustedTypes: { createPolicy(name: string, rules: object): object };
    };
    const script = document.createElement('script');
    // Code that the debugger evaluates may itself evaluate text; code that a timer calls may not.
    const evaluated = await new Promise<string>((resolve) => {
      setTimeout(() => resolve(failure(() => window.eval('1'))));
    });
    return {
      ran: window.ran,
      opacity: getComputedStyle(document.body).opacity,
      evaluated,
      markup: failure(() => (document.body.innerHTML = '<b>markup</b>')),
      script: failure(() => (script.src = './assets/script.js')),
      worker: failure(() => new Worker('./assets/worker.js')),
      policy: failure(() => trustedTypes.createPolicy('another', {})),
      elsewhere: await fetch('https://elsewhere.invalid/').catch(
        (error: unknown) => (error as Error).name,
      ),
    };
  });
  expect(outcome).toEqual({
    ran: [],
    opacity: '1',
    evaluated: 'EvalError',
    markup: 'TypeError',
    script: 'TypeError',
    worker: 'TypeError',
    policy: 'TypeError',
    elsewhere: 'TypeError',
  });
  const trustedTypes = 'require-trusted-types-for trusted-types-sink';
  await expect
    .poll(() => told)
    .toEqual([
      'script-src-attr inline',
      'script-src-elem inline',
      'style-src-elem inline',
      ...[trustedTypes, trustedTypes, trustedTypes, trustedTypes],
      'trusted-types trusted-types-policy',
      'connect-src https://elsewhere.invalid/',
    ]);
  // The page itself refuses the address, and requests nothing that the policy would block.
  const opened = page.evaluate(() => window.sinew.open('https://elsewhere.invalid/a.skel'));
  await expect(opened).rejects.toThrow('download it and drop it here');
  await page.close();
});
