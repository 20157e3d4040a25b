import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';
import { capture, getPose, openApp, openTab, setPose, startOver } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { countedUser } from './support/counted-user.ts';
import { courseCharacter } from './support/course-character.ts';
import { deformLab, middleOf, small } from './support/deform-lab.ts';
import type { Place } from './support/find-limb.ts';
import { coarse, openBundled, sharedPage, test } from './support/test.ts';
import { touchUser } from './support/touch-user.ts';

// What can be done in the deformation lab; deform-lab-pictures.spec.ts has what it looks like.
test.use({ ...coarse, viewport: { width: 900, height: 560 } });
const page = sharedPage(async (page) => {
  // The largest difference is at a vertex, which a press on its mark must hit.
  await openBundled(page, 'whole');
  await openApp(page, 'model=human');
});
const { canvas, change, mark, offered, press, ring, settled, wipe } = deformLab(page);

/** The pixels that the page shows, without what lies over them. */
async function seen(): Promise<PNG> {
  await settled();
  await page().evaluate(() => {
    document.querySelector<HTMLElement>('.overlay')!.style.visibility = 'hidden';
    (document.activeElement as HTMLElement | null)?.blur();
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const bytes = await canvas().screenshot();
  await page().evaluate(() => {
    document.querySelector<HTMLElement>('.overlay')!.style.visibility = '';
  });
  return PNG.sync.read(bytes);
}

async function drag(from: Place, toX: number, toY: number): Promise<void> {
  await page().mouse.move(from.x, from.y);
  await page().mouse.down();
  await page().mouse.move((from.x + toX) / 2, (from.y + toY) / 2);
  await page().mouse.move(toX, toY);
  await page().mouse.up();
}

/** Columns of pixels, which are parts of the width, in one list. */
function columns({ data, width, height }: PNG, from: number, to: number): Buffer {
  const [left, right] = [from, to].map((part) => Math.round(part * width));
  return Buffer.concat(
    Array.from({ length: height }, (_, y) =>
      data.subarray((y * width + left!) * 4, (y * width + right!) * 4),
    ),
  );
}

test('a click on the mark explains the vertex by both methods, and its weights are edited there', async () => {
  await setPose(page(), {});
  await press('x');
  await offered('Twist the forearm').click();
  await mark().click();
  const inspector = page().locator('.vertex-inspector');
  const number = inspector.getByRole('spinbutton', { name: /^Vertex/ });
  const last = (name: string) =>
    inspector.getByRole('region', { name }).getByRole('row', { name: /^Σ/ });
  const place = last('w·T·B⁻¹·p, and their sum: the vertex');
  await expect(place).toHaveText(/^Σ(-?\d\.\d{4}){3}$/);
  await expect(last('That motion of p: the vertex')).toBeVisible();
  expect(await violations(page())).toEqual([]);
  const [vertex, before] = [await number.inputValue(), await place.textContent()];
  const slider = inspector.getByRole('slider').first();
  await slider.fill('0.9');
  await expect(place).not.toHaveText(before!);
  await inspector.getByRole('button', { name: 'Reset vertex' }).click();
  await expect(place).toHaveText(before!);
  const undo = page().locator('.top [data-command="undo"]');
  await undo.click();
  await expect(place).not.toHaveText(before!);
  await undo.click();
  await expect(place).toHaveText(before!);
  await inspector.getByRole('combobox').selectOption({ index: 1 });
  const joints = inspector.getByRole('button', { name: /^Remove/ });
  const count = await joints.count();
  await joints.last().click();
  await expect(joints).toHaveCount(count - 1);
  const { x, y, width, height } = (await canvas().boundingBox())!;
  await page().mouse.click(x + 0.45 * width, y + 0.45 * height);
  await expect(number).not.toHaveValue(vertex);
  await number.fill('12');
  await expect(number).toHaveValue('12');
  await page().locator('.vertex-inspector > summary').click();
  await expect(number).toHaveCount(0);
  await press('x');
  await startOver(page());
});

test('in each part poses are dragged, and undo and the camera work', async () => {
  await setPose(page(), {});
  await press('x');
  await offered('Twist the forearm').click();
  const twisted = await getPose(page());
  await change('comparison-layout').click();
  const { x, y, width, height } = (await canvas().boundingBox())!;
  for (const part of [0, 1]) {
    const middle = { x: x + ((part + 0.5) * width) / 2, y: y + height / 2 };
    const marked = (await ring().nth(part).boundingBox())!;
    // The mark is at the arm's edge.
    const arm = { x: middleOf(marked) - 8, y: marked.y + marked.height / 2 - 8 };
    await page().mouse.click(arm.x, arm.y);
    for (const way of ['the limb', 'inverse kinematics']) {
      if (way !== 'the limb') await press('i');
      // The drag ends in the other part, as if its own went on there.
      await drag(arm, middle.x + (part === 0 ? width / 2 : -width / 2), arm.y - 30);
      expect(await getPose(page()), `a drag of ${way} poses`).not.toEqual(twisted);
      await page().locator('.top [data-command="undo"]').click();
      expect(await getPose(page())).toEqual(twisted);
    }
    await press('i');
    const free = { x: x + (part * width) / 2 + 30, y: y + height - 30 };
    for (const move of [() => drag(free, free.x + 20, free.y), () => page().mouse.wheel(0, 60)]) {
      const seenBefore = await capture(page(), 'png', small);
      await move();
      // The wheel is told later.
      await expect
        .poll(async () => (await capture(page(), 'png', small)).equals(seenBefore))
        .toBe(false);
    }
  }
  await page().locator('.top [data-command="undo"]').click();
  expect(await getPose(page())).not.toEqual(twisted);
  await page().locator('.top [data-command="redo"]').click();
  expect(await getPose(page())).toEqual(twisted);
});

test('a wipe is moved by a finger and by keys, and stays at its part of another window', async () => {
  await change('comparison-layout').click();
  const place = async () => Number(await wipe().getAttribute('aria-valuenow'));
  await wipe().focus();
  await page().keyboard.press('Home');
  expect(await place()).toBe(0);
  for (const key of ['ArrowRight', 'ArrowUp', 'ArrowLeft']) await page().keyboard.press(key);
  expect(await place()).toBe(2);
  const grip = (await wipe().boundingBox())!;
  const { width } = (await canvas().boundingBox())!;
  const { stroke } = await touchUser(page());
  await stroke({ x: middleOf(grip), y: grip.y + grip.height / 2 }, 0.5 * width, 3);
  expect(Math.abs((await place()) - 52)).toBeLessThanOrEqual(1);
  await page().setViewportSize({ width: 560, height: 760 });
  await settled();
  const [moved, view] = await Promise.all([wipe().boundingBox(), canvas().boundingBox()]);
  expect(Math.abs((middleOf(moved!) - view!.x) / view!.width - 0.52)).toBeLessThan(0.01);
  await page().setViewportSize({ width: 900, height: 560 });
});

test('the lab has its numbers in colors and in a table that can be read aloud', async () => {
  const lab = page().locator('.deform-lab');
  await openTab(page(), 'deform');
  await lab.getByRole('button', { name: 'Differences in color' }).click();
  await lab.getByRole('button', { name: 'Side by side' }).click();
  await settled();
  await expect(page().getByRole('region', { name: 'Legend of the differences' })).toContainText(
    '%',
  );
  const row = lab.getByRole('row', { name: /^dqs/ });
  await expect(row).toContainText(/0\.0\d+/);
  // Times come when the page was quiet for a moment.
  await expect(row.getByRole('cell').nth(3)).toHaveText(/^(< )?\d+(\.\d)?$/);
  expect(await violations(page())).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), onlyColors)).toEqual([]);
  await page().emulateMedia({ colorScheme: 'light' });
  await press('x');
  await startOver(page());
});

test('an engineer compares methods on own file and pose, and saves numbers and picture: 6 presses', async () => {
  const user = countedUser(page());
  const { x, y } = (await canvas().boundingBox())!;
  const files = courseCharacter();
  await user.drop(files, { x: x + 200, y: y + 200 });
  await expect(page().locator('header.subject')).toContainText('course');
  const pose = JSON.stringify(await getPose(page()));
  await user.drop([{ name: 'POSE.json', content: pose }], { x: x + 200, y: y + 200 });
  await settled();
  await user.click(page().getByRole('button', { name: /^Compare skinning methods/ }));
  await expect(page().locator('.compared')).toContainText('Dual quaternions');
  await user.click(page().locator('.top [data-tab="deform"]'));
  for (const [name, file] of [
    ['Save the differences of compared methods as CSV', /comparison\.csv$/],
    ['Save a picture', /\.png$/],
  ] as const) {
    const download = page().waitForEvent('download');
    const command = name === 'Save a picture' ? 'save-picture' : 'save-comparison';
    await user.click(page().locator(`.deform-lab [data-command="${command}"]`));
    expect((await download).suggestedFilename()).toMatch(file);
    if (command === 'save-picture') continue;
    const text = readFileSync(await (await download).path(), 'utf8');
    expect(text.split('\n')[0]).toBe('quantity,vertex,lbs,dqs');
    expect(text).toContain('volume / rest');
  }
  expect(user.presses).toBe(6);
  await press('x');
});

test('two, three and four parts, and those of a wipe, are the pictures there, pixel for pixel', async () => {
  await page().evaluate(() => window.sinew.open('tube'));
  await press('x');
  await expect(page().locator('.compared')).toContainText('Dual quaternions');
  await change('compare-one-more').click();
  await expect(page().locator('.compared')).toContainText('Centers of rotation');
  await change('comparison-layout').click();
  const { width, height } = PNG.sync.read(await canvas().screenshot());
  const methods = ['linear-blend', 'dual-quaternion', 'centers-of-rotation', 'delta-mush'] as const;
  /** One method as if it had the whole view, or a part of that width. */
  const single = async (index: number, size: { readonly width: number }): Promise<PNG> =>
    PNG.sync.read(await capture(page(), 'png', { height, ...size }, [{ method: methods[index]! }]));
  const expectParts = async (count: number): Promise<void> => {
    const parts = await seen();
    const each = Math.floor(width / count);
    for (let index = 0; index < count; index++) {
      const from = index * each;
      const part = { width: index === count - 1 ? width - from : each };
      const [shown, expected] = [
        columns(parts, from / width, (from + part.width) / width),
        columns(await single(index, part), 0, 1),
      ];
      expect(shown.equals(expected), `part ${index + 1} of ${count}`).toBe(true);
    }
  };
  const expectWiped = async (count: number): Promise<void> => {
    const wiped = await seen();
    const places = await page()
      .locator('.wipe')
      .evaluateAll((all) => all.map((each) => parseFloat((each as HTMLElement).style.left) / 100));
    expect(places).toHaveLength(count - 1);
    // Parts of a wipe begin at even pixels.
    const edges = [0, ...places, 1].map((place) => (2 * Math.round((place / 2) * width)) / width);
    for (let index = 0; index < count; index++) {
      const whole = await single(index, { width });
      const part = [edges[index]!, edges[index + 1]!] as const;
      expect(
        columns(wiped, ...part).equals(columns(whole, ...part)),
        `part ${index + 1} of ${count} under a wipe`,
      ).toBe(true);
    }
  };
  await expectParts(3);
  await change('compare-one-more').click();
  await expect(page().locator('.compared')).toContainText('Delta mush');
  await expectParts(4);
  await change('comparison-layout').click();
  await expectWiped(4);
  await openTab(page(), 'deform');
  for (const name of ['Delta mush', 'Centers of rotation']) {
    await page()
      .getByRole('button', { name: `Compare without ${name}` })
      .click();
  }
  await change('comparison-layout').click();
  await expectParts(2);
  await change('comparison-layout').click();
  await expectWiped(2);

  // What is said and shown is of the character that is selected, also of one that comes.
  const notice = page().locator('.notice');
  const name = page().locator('.actors .name');
  await page().evaluate(() => window.sinew.add('hand'));
  await name.filter({ hasText: 'tube' }).click();
  await expect(notice).toHaveText(/differ by at most 0\.\d+ \(9/);
  await name.filter({ hasText: 'hand' }).click();
  await expect(notice).not.toHaveText(/\(9/);
});
