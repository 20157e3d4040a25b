import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { largestDifference } from '../tests/support/compare.ts';
import { controlRow, drop, getPose, openApp, setPose, vertices } from './support/app.ts';
import { wildPose } from './support/poses.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// Poses are saved and restored as files, through the clipboard and in pictures; the posed mesh can
// be saved too.
test.use({ ...coarse, viewport: { width: 960, height: 480 } });

const page = sharedPage(async (page) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await openApp(page);
});
const notice = () => page().locator('.notice');
const problems = () => page().evaluate(() => window.sinew.problems);

async function saved(row: string) {
  const button = controlRow(page(), row).locator('button');
  const [download] = await Promise.all([page().waitForEvent('download'), button.click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test('dropping a saved pose restores the pose', async () => {
  const wild = wildPose(32, 4);
  const pose = await setPose(page(), wild);
  expect(pose.root).toEqual(wild.root);
  const shape = await vertices(page(), 'gpu');
  const { name, bytes } = await saved('Save pose');
  expect(name).toBe('human.pose.json');
  expect(JSON.parse(bytes.toString())).toEqual(pose);
  await setPose(page(), {});
  await drop(page(), [{ name, content: bytes }]);
  expect(await getPose(page())).toEqual(pose);
  expect(await vertices(page(), 'gpu')).toEqual(shape);
  expect(await problems()).toEqual([]);
  await expect(notice()).toHaveText('Pose set');
});

test('a copied pose is the text of the saved file', async () => {
  const pose = await setPose(page(), wildPose(32, 5));
  await controlRow(page(), 'Copy pose').locator('button').click();
  await expect(notice()).toHaveText('Pose copied');
  const copied = await page().evaluate(() => navigator.clipboard.readText());
  expect(JSON.parse(copied)).toEqual(pose);
});

test('a pose with an unknown joint is not used, and the joint is named', async () => {
  const before = await setPose(page(), { joints: { Chest: [0.1, 0.2, 0.3] } });
  const content = JSON.stringify({ joints: { Chest: [1, 1, 1], Tail: [0, 0, 0] } });
  await drop(page(), [{ name: 'tail.json', content }]);
  expect(await getPose(page())).toEqual(before);
  expect(await problems()).toMatchObject([{ code: 'pose/unknown-joint', found: 'Tail' }]);
  await expect(page().locator('.problems')).toContainText('tail.json');
});

test('dropping a saved picture restores its pose', async () => {
  const pose = await setPose(page(), wildPose(32, 6));
  await page().locator('canvas.scene').focus();
  const [download] = await Promise.all([
    page().waitForEvent('download'),
    page().keyboard.press('j'),
  ]);
  await setPose(page(), {});
  await drop(page(), [{ name: 'human.png', content: readFileSync(await download.path()) }]);
  expect(await getPose(page())).toEqual(pose);
});

test('the posed mesh is saved as shown, in the file’s order and units', async () => {
  await setPose(page(), wildPose(32, 7));
  const { name, bytes } = await saved('Export posed OBJ');
  expect(name).toBe('human-posed.obj');
  const lines = bytes.toString().split('\n');
  const positions = lines
    .filter((line) => line.startsWith('v '))
    .flatMap((line) => line.split(' ').slice(1).map(Number));
  const cpu = await vertices(page(), 'cpu');
  expect(positions).toHaveLength(cpu.length);
  // Nine digits represent every float32 exactly.
  expect(largestDifference(Float32Array.from(positions), cpu)).toBe(0);
  const { triangleCount } = (await page().evaluate(() => window.sinew.characters))[0]!;
  expect(lines.filter((line) => line.startsWith('f '))).toHaveLength(triangleCount);
});
