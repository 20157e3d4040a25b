import { writeFileSync } from 'node:fs';
import { type CDPSession, expect, type Page } from '@playwright/test';
import { chooseFromMenu, expectFittingCanvas } from './support/app.ts';
import { onlyColors, violations } from './support/axe.ts';
import { madeCharacter } from './support/made-character.ts';
import { coarse, sharedPage, test } from './support/test.ts';

// Files are dragged over the page by the browser itself, and go where the view says.
test.use({ ...coarse, viewport: { width: 1100, height: 480 } });
// The page begins as a first visit does, because no later one does: the scene of an earlier visit is
// restored.
const page = sharedPage(async (page) => {
  await page.goto('./');
  await page.evaluate(() => window.sinew.ready);
  await page.evaluate(() => window.sinew.settled());
  await expectFittingCanvas(page);
});

const halves = () => page().locator('.drop-zone:popover-open > div');
const lit = () => page().locator('.drop-zone:popover-open > .lit');
const names = () => page().evaluate(() => window.sinew.characters.map(({ name }) => name));
const dialog = () => page().getByRole('dialog', { name: 'Replace or add' });

/** Writes the files of a small character, and returns their paths. */
function filesOf(name: string): string[] {
  return madeCharacter(3, 1).map((file) =>
    write(file.name.replace('made', name), String(file.content)),
  );
}

function write(name: string, content: string): string {
  const path = test.info().outputPath(name);
  writeFileSync(path, content);
  return path;
}

type DragStep = 'dragEnter' | 'dragOver' | 'drop';

/** A drag of files; each step goes to a place of the window in fractions of the view's size. */
async function startDrag(files: readonly string[]) {
  const session: CDPSession = await page().context().newCDPSession(page());
  const data = { items: [], files: [...files], dragOperationsMask: 1 };
  const view = (await page().locator('canvas.scene').boundingBox())!;
  return async (type: DragStep, across: number, down = 0.5): Promise<void> => {
    const [x, y] = [view.x + across * view.width, view.y + down * view.height];
    await session.send('Input.dispatchDragEvent', { type, x, y, data });
  };
}

async function dropAt(files: readonly string[], across: number): Promise<void> {
  const drag = await startDrag(files);
  await drag('dragEnter', across);
  await drag('dragOver', across);
  await drag('drop', across);
}

test('on the first scene, which nobody touched, a drop anywhere replaces all of it', async () => {
  const first = await names();
  expect(first.length, 'characters of the first visit').toBeGreaterThan(1);
  const drag = await startDrag(filesOf('one'));
  await drag('dragEnter', 0.9);
  await drag('dragOver', 0.9);
  await expect(halves()).toHaveText(['Drop to open']);
  await expect(lit()).toHaveCount(1);
  await drag('drop', 0.9);
  await expect(halves()).toHaveCount(0);
  await expect.poll(names).toEqual(['one']);
  await page().keyboard.press('Control+z');
  await expect.poll(names, 'one step of undo').toEqual(first);
  await page().keyboard.press('Control+Shift+z');
  await expect.poll(names).toEqual(['one']);
});

test('afterwards two halves of the view name the choice, and a third file makes three', async () => {
  const drag = await startDrag(filesOf('two'));
  await drag('dragEnter', 0.2);
  await drag('dragOver', 0.2);
  await expect(halves()).toHaveText(['Replace one', 'Add']);
  await expect(lit()).toHaveText('Replace one');
  await drag('dragOver', 0.8);
  await expect(lit()).toHaveText('Add');
  // The halves cover the view and nothing else.
  const view = (await page().locator('canvas.scene').boundingBox())!;
  for (const half of await halves().all()) {
    const { x, y, width, height } = (await half.boundingBox())!;
    expect(x).toBeGreaterThanOrEqual(view.x);
    expect(y).toBeGreaterThanOrEqual(view.y);
    expect(x + width).toBeLessThanOrEqual(view.x + view.width);
    expect(y + height).toBeLessThanOrEqual(view.y + view.height);
  }
  // Over a panel, the nearer half counts.
  await drag('dragOver', -0.1);
  await expect(lit()).toHaveText('Replace one');
  // The protocol that drags cannot leave the window.
  await page().locator('aside.left').dispatchEvent('dragleave');
  await expect(halves()).toHaveCount(0);
  expect(await names()).toEqual(['one']);

  await dropAt(filesOf('two'), 0.8);
  await expect.poll(names).toEqual(['one', 'two']);
  await dropAt(filesOf('three'), 0.8);
  await expect.poll(names).toEqual(['one', 'two', 'three']);
  await dropAt(filesOf('four'), 0.2);
  await expect.poll(names).toEqual(['one', 'two', 'four']);
  await page().keyboard.press('Control+z');
  await expect.poll(names).toEqual(['one', 'two', 'three']);
});

test('a pose and a picture have no choice: they belong to the selected character', async () => {
  const pose = write('some.pose.json', '{"joints":{"#1":[0.5,0,0]}}');
  const drag = await startDrag([pose]);
  await drag('dragEnter', 0.8);
  await expect(halves()).toHaveText(['Drop on a character']);
  await drag('drop', 0.8);
  await expect(page().locator('output.notice')).toHaveText('Pose set');
  expect(await names()).toHaveLength(3);
});

test('a pose goes to the character under the pointer', async () => {
  const selected = () =>
    page().evaluate(() => window.sinew.characters.find((each) => each.selected)?.name);
  const angle = () =>
    page().evaluate(() => window.sinew.pose(undefined, 'one').joints?.['joint 01']);
  await page().evaluate(() => window.sinew.select('one'));
  const box = (await page().locator('canvas.scene').boundingBox())!;
  /** Where a click selects another character, from left to right. */
  const findOther = async (): Promise<number> => {
    for (let across = 0.1; across < 0.95; across += 0.01) {
      await page().mouse.click(box.x + across * box.width, box.y + 0.5 * box.height);
      if ((await selected()) !== 'one') return across;
    }
    throw new Error('no click selects another character');
  };
  const across = await findOther();
  const other = await selected();
  await page().evaluate(() => window.sinew.select('one'));
  const before = await angle();
  await dropAt([write('other.pose.json', '{"joints":{"#1":[0.25,0,0]}}')], across);
  await expect.poll(selected).toBe(other);
  await expect
    .poll(() => page().evaluate((name) => window.sinew.pose(undefined, name), other))
    .toMatchObject({ joints: { 'joint 01': [0.25, 0, 0] } });
  expect(await angle()).toEqual(before);
  await page().evaluate(() => window.sinew.select('three'));
});

test('a drop on an open dialog shows the halves over it', async () => {
  await page().keyboard.press('Control+k');
  await expect(page().getByRole('dialog', { name: 'Commands' })).toBeVisible();
  const drag = await startDrag(filesOf('five'));
  await drag('dragEnter', 0.8);
  await expect(halves()).toHaveText(['Replace three', 'Add']);
  await drag('dragOver', 0.2);
  await expect(lit()).toHaveText('Replace three');
  await drag('drop', 0.2);
  await expect.poll(names).toEqual(['one', 'two', 'five']);
  await page().keyboard.press('Escape');
});

/** Opens files by the menu, as without a mouse that drags. */
async function choose(page: Page, files: readonly string[]): Promise<void> {
  const choosing = page.waitForEvent('filechooser');
  await chooseFromMenu(page, 'Open files');
  await (await choosing).setFiles([...files]);
}

test('chosen files offer the same by name: Enter replaces, Escape opens nothing', async () => {
  await choose(page(), filesOf('six'));
  await expect(dialog()).toBeVisible();
  const replace = dialog().getByRole('button', { name: 'Replace five' });
  await expect(replace).toBeFocused();
  expect(await violations(page(), { within: 'dialog' })).toEqual([]);
  await page().emulateMedia({ colorScheme: 'dark' });
  expect(await violations(page(), { within: 'dialog', ...onlyColors })).toEqual([]);
  await page().keyboard.press('Enter');
  await expect(dialog()).toHaveCount(0);
  await expect.poll(names).toEqual(['one', 'two', 'six']);

  await choose(page(), filesOf('seven'));
  await dialog().getByRole('button', { name: 'Add seven' }).click();
  await expect.poll(names).toEqual(['one', 'two', 'six', 'seven']);
  await expect(page().locator('output.notice')).toHaveText('seven added');

  await choose(page(), filesOf('eight'));
  await expect(dialog()).toBeVisible();
  await page().keyboard.press('Escape');
  await expect(dialog()).toHaveCount(0);
  expect(await names()).toHaveLength(4);
});

test('files that complete or update the open character are not asked about', async () => {
  const [skel, ...rest] = filesOf('nine');
  await choose(page(), [skel!]);
  await dialog().getByRole('button', { name: 'Add nine' }).click();
  await expect.poll(async () => (await names()).at(-1)).toBe('nine');
  await choose(page(), rest);
  await expect(page().locator('output.notice')).toContainText('updated');
  expect(await names()).toHaveLength(5);
  await expect(dialog()).toHaveCount(0);
});
