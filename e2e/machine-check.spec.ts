import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { kernels } from '../src/skinning/registry.ts';
import type { MachineReport } from '../src/app/check-machine.ts';
import { chooseFromMenu, openApp } from './support/app.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use(coarse);

// Every method links every variant and poses a character.
test.describe.configure({ timeout: 120_000 });

const page = sharedPage(openApp);
const check = () => chooseFromMenu(page(), 'Check this machine');
const notice = () => page().locator('.notice');

test('this machine is checked, the report is saved, and the page stays as it was', async () => {
  const before = await page().evaluate(() => JSON.stringify(window.sinew.liveObjects));
  const saved = page().waitForEvent('download');
  await check();
  const download = await saved;
  expect(download.suggestedFilename()).toBe('sinew-machine.json');
  const report = JSON.parse(readFileSync(await download.path(), 'utf8')) as MachineReport;

  expect(report.machine.renderer).toContain('SwiftShader');
  expect(report.machine.limits['MAX_SAMPLES']).toBeGreaterThanOrEqual(4);
  expect(report.programs.filter(({ problem }) => problem !== null)).toEqual([]);
  const names = report.programs.map(({ name }) => name);
  expect(names).toEqual(expect.arrayContaining(['mesh', 'floor', 'solid', 'line']));
  // Delta mush is computed on the CPU alone.
  const onGpu = kernels.filter(({ id }) => id !== 'delta-mush');
  for (const { id } of onGpu) {
    const layouts = names.filter((name) => name.startsWith(`${id} of `));
    expect(
      layouts.length,
      'five ways to store influences, three to store a palette',
    ).toBeGreaterThan(0);
    expect(layouts.length % 15).toBe(0);
  }
  expect(report.parity).toEqual(
    onGpu.map(({ id }) => expect.objectContaining({ kernel: id, identical: true, position: 0 })),
  );
  const { posed, camera, triangles } = report.frames;
  expect(triangles).toBeGreaterThan(1000);
  for (const { all, median, least } of [posed, camera]) {
    expect(all.length).toBeGreaterThanOrEqual(3);
    expect(least).toBe(Math.min(...all));
    expect(all).toContain(median);
    expect(least).toBeGreaterThan(0);
  }
  await expect(notice()).toHaveText(
    /^Report saved: \d+ programs link, GPU = CPU, posed frame [\d.]+ ms, camera [\d.]+ ms$/,
  );
  expect(await page().evaluate(() => JSON.stringify(window.sinew.liveObjects))).toBe(before);
});

test('the check shows its progress and can be canceled', async () => {
  let saved = false;
  page().on('download', () => (saved = true));
  await check();
  await expect(page().locator('.progress')).toContainText(/Checking this machine: \w+/);
  await page().getByRole('button', { name: 'Cancel', exact: true }).click();
  await expect(notice()).toHaveText('Canceled');
  await expect(page().locator('.progress')).toBeHidden();
  await page().evaluate(() => window.sinew.settled());
  expect(saved).toBe(false);
  await expect(notice()).toHaveText('Canceled');
});
