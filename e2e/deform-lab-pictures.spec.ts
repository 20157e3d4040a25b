import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { unzipSync } from 'fflate';
import { PNG } from 'pngjs';
import {
  bytesOf,
  capture,
  chooseFromMenu,
  getPose,
  openApp,
  openTab,
  setPose,
} from './support/app.ts';
import { countedUser } from './support/counted-user.ts';
import { deformLab, middleOf, small } from './support/deform-lab.ts';
import { expectPicture } from './support/pictures.ts';
import { drawPlainly, sharedPage, test } from './support/test.ts';

// What the deformation lab looks like; deform-lab.spec.ts has what can be done there.
test.use({ viewport: { width: 900, height: 560 } });
const page = sharedPage(async (page) => {
  await drawPlainly(page);
  await openApp(page, 'model=human');
});
const { canvas, change, explained, mark, offered, press, ring, settled, wipe } = deformLab(page);

/** Compares the view with what the lab shows over it, without the tools and hints that others have. */
async function expectWalked(name: string): Promise<void> {
  await settled();
  const others = '.overlay > :not(.compared, .worst-mark, .wipe, .comparison-foot, .ghost-labels)';
  const show = (visibility: string) =>
    page().evaluate(
      ([others, visibility]) => {
        for (const each of document.querySelectorAll<HTMLElement>(others!)) {
          each.style.visibility = visibility!;
        }
        (document.activeElement as HTMLElement | null)?.blur();
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      },
      [others, visibility],
    );
  await show('hidden');
  expectPicture(name, await canvas().screenshot());
  await show('');
}

test('four actions lead from x to the reason of the largest difference, and back', async () => {
  await setPose(page(), {});
  const [before, plain] = [await getPose(page()), await capture(page(), 'png', small)];
  // A key that is pressed twice before the lab is there closes it again.
  await press('x');
  await page().keyboard.press('x');
  await settled();
  await expect(page().locator('.compared')).toHaveCount(0);

  await press('x');
  await expect(page().locator('.offered')).toContainText('hardly differ');
  await expectWalked('lab-at-rest');

  await offered('Twist the forearm').click();
  await expect(mark()).toHaveText(/^0\.\d+ \([1-9](\.\d+)? %\)$/);
  await expect(page().locator('.offered')).toHaveCount(0);
  await expect(page().locator('.compared')).toHaveText('Linear blend (SSD)Dual quaternions');
  const [wiped, marked] = await Promise.all([wipe().boundingBox(), ring().boundingBox()]);
  expect(Math.abs(middleOf(wiped!) - middleOf(marked!)), 'the wipe is at the place').toBeLessThan(
    2,
  );
  await expectWalked('lab-wipe');

  await mark().click();
  await expect(mark()).toHaveAttribute('aria-pressed', 'true');
  await expect(explained('w·T·B⁻¹·p, and their sum: the vertex')).toBeVisible();
  await expect(explained('That motion of p: the vertex')).toBeVisible();
  await expectWalked('lab-inspector');

  await press('Escape');
  await expect(mark()).toHaveCount(0);
  expect(await getPose(page())).toEqual(before);
  expect((await capture(page(), 'png', small)).equals(plain), 'the camera is back').toBe(true);
});

test('a picture and a movie are saved with differences in color, side by side, and labels', async () => {
  const lab = page().locator('.deform-lab');
  await press('x');
  await offered('Twist the forearm').click();
  await openTab(page(), 'deform');
  await lab.getByRole('button', { name: 'Differences in color' }).click();
  await lab.getByRole('button', { name: 'Side by side' }).click();
  await settled();
  const [saved] = await Promise.all([
    page().waitForEvent('download'),
    lab.locator('[data-command="save-picture"]').click(),
  ]);
  const file = readFileSync(await saved.path());
  expectPicture('lab-saved', file);
  const { width, height, data } = PNG.sync.read(file);
  const labeled = await bytesOf(
    await page().evaluateHandle((options) => window.sinew.capture(options), {
      ...{ width, height, labels: true },
    }),
  );
  expect(PNG.sync.read(labeled).data.equals(data), 'a script has the same labels').toBe(true);
  const frames = await bytesOf(
    await page().evaluateHandle(() =>
      window.sinew.movie({
        ...{ format: 'png', plays: false, width: 640, height: 400 },
        ...{ turns: true, turnSeconds: 1, rate: 2 },
      }),
    ),
  );
  expectPicture('lab-movie', Buffer.from(unzipSync(frames)['frame-0000.png']!));
  await press('x');
});

test('a teacher shows the twisted tube under three methods: 5 presses', async () => {
  await chooseFromMenu(page(), 'New');
  const user = countedUser(page());
  await user.click(page().getByRole('button', { name: 'Add…' }));
  const gallery = page().getByRole('dialog');
  await user.click(gallery.getByRole('button', { name: 'Twisting tube', exact: true }));
  await expect(page().locator('header.subject')).toContainText('tube');
  await settled();
  await user.click(page().getByRole('button', { name: /^Compare skinning methods/ }));
  await expect(page().locator('.compared')).toContainText('Dual quaternions');
  await user.click(change('compare-one-more'));
  await expect(page().locator('.compared')).toContainText('Centers of rotation');
  await user.click(change('comparison-layout'));
  await settled();
  expect(user.presses).toBeLessThanOrEqual(5);
  await expectWalked('lab-tube');
});
