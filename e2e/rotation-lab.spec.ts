import { expect } from '@playwright/test';
import { drop, openApp, openTab } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

const skel = `balljoint base {
  boxmin -0.1 0 -0.1  boxmax 0.1 0.3 0.1
  balljoint arm {
    offset 0 0.3 0
    boxmin -0.05 0 -0.05  boxmax 0.05 0.5 0.05
    balljoint hand { offset 0 0.5 0  boxmin -0.07 0 -0.03  boxmax 0.07 0.15 0.03 }
  }
}
`;
/** The arm's middle angle, Y, goes through a right angle: 1.9 radians are 109°. */
const armAngles = [
  [0, 0.9, 0.3, -0.4],
  [-0.3, 1.9, 0.7, 0.1],
  [0, -0.8, 1.1, 0.5],
];
const still = '  channel { extrapolate constant constant keys 1 { 0 0 flat flat } }\n';
const arm = armAngles.map((angles) => {
  const keys = angles.map((angle, time) => `${time} ${angle} smooth smooth`).join('  ');
  return `  channel { extrapolate constant constant keys 4 { ${keys} } }\n`;
});
const anim = `animation {
  range 0 3
  numchannels 12
${still.repeat(6)}${arm.join('')}${still.repeat(3)}}
`;

test.use({ viewport: { width: 960, height: 700 } });
const page = sharedPage(async (page) => {
  await openApp(page, 'model=tube');
  await drop(page, [
    { name: 'arm.skel', content: skel },
    { name: 'arm.anim', content: anim },
  ]);
  await openTab(page, 'animate');
});

const lab = () => page().locator('.rotation-lab');
const select = (joint: string) =>
  page().locator('[role=treeitem]', { hasText: new RegExp(`${joint}$`) });
const notice = () => page().locator('output.notice');
const button = (name: string) => lab().getByRole('button', { name, exact: true });
const seek = async (time: number): Promise<void> => {
  await page().getByRole('slider', { name: 'Time' }).fill(String(time));
};

test('the lab is found by keys, and draws three charts that can be read aloud', async () => {
  await page().keyboard.press('Control+k');
  await expect(page().getByRole('dialog').getByRole('combobox')).toBeFocused();
  await page().keyboard.type('Rotation lab');
  await page().keyboard.press('Enter');
  await expect(lab().locator('> summary')).toBeFocused();
  await expect(lab()).toContainText('Select a joint that the clip turns');
  await select('arm').click();
  const charts = lab().getByRole('img');
  await expect(charts).toHaveCount(3);
  await expect(charts.first()).toHaveAccessibleName(
    /^Euler angles \(stored\) of arm, 0.00 to 3.00 s: X from .*Y from .*Z from .*; singular at /,
  );
  await expect(charts.nth(1)).toHaveAccessibleName(/^Swing and twist of arm/);
  await expect(charts.nth(2)).toHaveAccessibleName(/^Rotation vector of arm/);
});

test('the numbers at the playhead are a table, and a fold is said in words', async () => {
  await seek(1);
  const row = lab().getByRole('row', { name: /Euler angles/ });
  await expect(row).toContainText('X 51.6°');
  await expect(row).toContainText('Y 108.9°');
  await expect(lab()).not.toContainText('Gimbal lock');
  await seek(0.74);
  await expect(lab()).toContainText(/Gimbal lock: Z and X turn about one axis/);
});

test('lab and paths look as they should, in colors that a checker accepts', async () => {
  await page().evaluate(() => window.sinew.settled());
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  expectPicture('rotation-lab-paths', await page().locator('canvas.scene').screenshot());
  expect(await violations(page(), { within: '.rotation-lab' })).toEqual([]);
  await page().setViewportSize({ width: 1440, height: 1900 });
  expectPicture('rotation-lab', await lab().screenshot());
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: '.rotation-lab', ...onlyColors })).toEqual([]);
});

test('storing as squad says the largest difference and is one step of undo', async () => {
  await button('Store as Squad').click();
  await expect(notice()).toHaveText(/^arm stored as squad; it differs by at most [\d.]+° at /);
  await expect(button('Store as Squad')).toHaveAttribute('aria-pressed', 'true');
  await expect(lab().getByRole('img').nth(2)).toHaveAccessibleName(/quaternions by squad/);
  await expect(lab()).toContainText(/It turns the curve by at most [\d.]+°/);
  await button('Insert a key here').click();
  await expect(notice()).toHaveText(/^Key of arm at 0\.7\d s/);
  await page().keyboard.press('Control+z');
  await page().keyboard.press('Control+z');
  await expect(button('Store as Euler')).toHaveAttribute('aria-pressed', 'true');
  await expect(lab()).toContainText('It does not change the motion.');
});

test('ghosts of a character without a skin are of its bones', async () => {
  await lab().locator('> summary').click();
  await page().emulateMedia({ colorScheme: 'light' });
  await page().setViewportSize({ width: 960, height: 700 });
  await seek(1.5);
  await page()
    .locator('[data-section="motion"]')
    .getByRole('checkbox', { name: 'Ghosts', exact: true, includeHidden: true })
    .dispatchEvent('click');
  await page().evaluate(() => window.sinew.settled());
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  await page().evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  expectPicture('ghosts-of-bones', await page().locator('canvas.scene').screenshot());
});
