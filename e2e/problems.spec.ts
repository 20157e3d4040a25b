import { expect } from '@playwright/test';
import { drop, openApp } from './support/app.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

test.use({ ...coarse, viewport: { width: 960, height: 480 } });

const page = sharedPage(async (page) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await openApp(page, 'model=tube');
});
const panel = () => page().locator('.problems');
const names = () => page().evaluate(() => window.sinew.characters.map(({ name }) => name));

test('a bad file keeps the character, and the problem says where, what and why', async () => {
  await drop(page(), [{ name: 'bad.skel', content: '0 0 0 -1\n0 1 zero 0\n' }]);
  expect(await names()).toEqual(['tube']);
  const [problem] = await page().evaluate(() => window.sinew.problems);
  expect(problem).toMatchObject({ file: 'bad.skel', line: 2, column: 5, severity: 'error' });
  await expect(panel().getByRole('heading')).toHaveText('Problems (1)');
  await expect(panel().getByRole('alert')).toBeVisible();
  const item = panel().getByRole('listitem');
  await expect(item.locator('strong')).toHaveText('bad.skel:2:5');
  await expect(item.locator('code')).toHaveText('0 1 zero 0');
  await expect(item.locator('dt')).toHaveText(['expected', 'found', 'so']);
  await expect(item.locator('dd')).toHaveText([
    'a number for z',
    'zero',
    'the skeleton is not used',
  ]);
  await expect(page().locator('.status')).toContainText('1 problem');
});

test('all problems can be copied as text, and disappear when dismissed', async () => {
  await drop(page(), [{ name: 'bad.skel', content: '0 0 0 -1\n0 1 zero 0\n' }]);
  await panel().getByRole('button', { name: 'Copy' }).click();
  await expect(page().locator('.notice')).toHaveText('Problems copied');
  const copied = await page().evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(
    'error: bad.skel:2:5: expected a number for z, found "zero"; ' +
      'the skeleton is not used [skel/number]',
  );
  await panel().getByRole('button', { name: 'Dismiss' }).click();
  await expect(panel()).toHaveCount(0);
  await expect(page().locator('.status')).not.toContainText('problem');
});

test('files that Sinew does not read are named', async () => {
  await drop(page(), [{ name: 'notes.txt', content: 'hello' }]);
  expect(await names()).toEqual(['tube']);
  await expect(panel()).toContainText('notes.txt');
  await expect(panel()).toContainText('the file is not used');
});

test('names from files are text, never markup', async () => {
  const name = '<img src=x onerror=alert(1)>';
  await drop(page(), [{ name: `${name}.skel`, content: `${name}\n` }]);
  await expect(panel().locator('strong')).toContainText(name);
  await expect(panel().locator('code')).toHaveText(name);
  const [skel, obj, attach] = madeCharacter(4, 2);
  await drop(page(), [
    { ...skel!, name: `${name}.skel` },
    { ...obj!, name: `${name}.obj` },
    { ...attach!, name: `${name}.attach` },
  ]);
  await expect(page().locator('.status strong')).toHaveText(name);
  await expect(page().getByRole('button', { name, exact: true })).toBeVisible();
  await expect(page().locator('img')).toHaveCount(0);
  await page().getByRole('button', { name: 'Undo' }).click();
  expect(await names()).toEqual(['tube']);
});
