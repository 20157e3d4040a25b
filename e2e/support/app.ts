import { expect, type JSHandle, type Locator, type Page } from '@playwright/test';
import type { CaptureView } from '../../src/app/scripting.ts';
import type { SkinDevice } from '../../src/document/session.ts';
import type { PoseJson } from '../../src/formats/pose-json.ts';
import type { KernelId } from '../../src/skinning/method.ts';
import { deformationOf, menuName, methods, normalWays } from '../../src/skinning/registry.ts';
import { type TabId, tabs } from '../../src/ui/tabs.ts';
import type { PictureFormat } from '../../src/view/picture/encode-picture.ts';
import type { Verification } from '../../src/document/verification.ts';
import './test.ts';

/**
 * Opens the page with a view of 640 × 480 and waits for its first picture. The controls exist but
 * are out of sight.
 */
export async function openView(page: Page, query = ''): Promise<void> {
  await page.setViewportSize({ width: 860, height: 480 });
  await open(page, `./?test&${query}`);
}

/** Opens a small view, for tests that check numbers and need no picture. */
export async function openSmallView(page: Page, query = ''): Promise<void> {
  await openView(page, query);
  // This sets properties of the style object, because the page's content policy forbids inline
  // style sheets.
  await page.evaluate(() => {
    Object.assign(document.querySelector<HTMLElement>('#app > .view')!.style, {
      width: '160px',
      height: '120px',
    });
  });
  await expectFittingCanvas(page);
}

/** Opens the page as users see it and waits for its panels. */
export async function openApp(page: Page, query = ''): Promise<void> {
  await open(page, query === '' ? './' : `./?${query}`);
  await expect(page.locator('.status')).toBeVisible();
  await expect(page.locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
  await page.locator('.status [aria-expanded=false]').dispatchEvent('click');
  await expectFittingCanvas(page);
}

/**
 * Returns a page to what its address opened, in the state of a first visit to a workspace, by
 * undoing all edits. This takes a tenth of the time of loading the page again.
 */
export async function startOver(page: Page, workspace = 'studio'): Promise<void> {
  await openTab(page, 'animate');
  await openTab(page, 'pose');
  await page.locator('[data-section="view"] select').first().waitFor({ state: 'attached' });
  await page.evaluate(async (wanted) => {
    const later = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve));
    const button = (command: string) =>
      document.querySelector<HTMLButtonElement>(`[data-command="${command}"]`);
    // Releasing a clip keeps its pose.
    const release = (): void => {
      const found = button('release-clip');
      if (!found || found.disabled) return;
      found.click();
      window.sinew.pose({});
    };
    // The change of workspace frames what is shown.
    release();
    await later();
    // What is drawn, and how, is reset only by a change of workspace, which may be a step of undo.
    const menu = document.querySelector<HTMLSelectElement>('[data-section="view"] select')!;
    const ids = Array.from(menu.options, ({ value }) => value);
    for (const id of [ids.find((each) => each !== wanted)!, wanted]) {
      menu.value = id;
      menu.dispatchEvent(new Event('change'));
      await later();
    }
    for (; !button('undo')!.disabled; await later()) button('undo')!.click();
    // Binding a clip is not a step of undo, so that undo has bound it again.
    release();
  }, workspaceLabels[workspace] ?? workspace);
  await choose(page, 'Compare with', 'Nothing');
  await openTab(page, 'pose');
}

/** The names of workspaces in their menu, by their ids. */
const workspaceLabels: Readonly<Record<string, string>> = {
  studio: 'Studio',
  '6.837': '6.837',
  cse169: 'CSE169',
  mannequin: 'Mannequin',
};

/** Opens a task of the page, and waits until its sections are there. */
export async function openTab(page: Page, tab: TabId): Promise<void> {
  await page.locator('.top [data-tab]').first().waitFor({ state: 'attached' });
  await page.evaluate((id) => {
    document.querySelector<HTMLElement>(`.top [data-tab="${id}"]`)!.click();
  }, tab);
  await expect(page.locator('[data-section]:not([hidden]):empty')).toHaveCount(0);
}

/** Waits for the canvas, which fits the space between the panels one frame late. */
export async function expectFittingCanvas(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const { width, height, clientWidth, clientHeight } = document.querySelector('canvas')!;
    const isFitting = (pixels: number, size: number): boolean =>
      Math.abs(pixels - size * devicePixelRatio) <= 1;
    return isFitting(width, clientWidth) && isFitting(height, clientHeight);
  });
}

/** Most tests are about one character; a visit without a name would open a scene. */
async function open(page: Page, address: string): Promise<void> {
  const named = /[?&]model=/.test(address)
    ? address
    : `${address}${/\?/.test(address) ? '&' : '?'}model=human`;
  await page.goto(named);
  await page.evaluate(() => window.sinew.ready);
}

export interface NamedFile {
  readonly name: string;
  readonly content: string | Uint8Array;
}

/** Drops files on the view as a user would, and waits until they have been read. */
export async function drop(page: Page, files: readonly NamedFile[]): Promise<void> {
  const encoded = files.map(({ name, content }) => ({
    name,
    base64: Buffer.from(content).toString('base64'),
  }));
  await page.evaluate(async (encoded) => {
    const transfer = new DataTransfer();
    for (const { name, base64 } of encoded) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      transfer.items.add(new File([bytes], name));
    }
    const before = window.sinew.problems;
    const view = document.querySelector('canvas')!;
    const happen = (type: string): boolean =>
      view.dispatchEvent(
        new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }),
      );
    happen('dragenter');
    // If the page does not handle the drop, the browser navigates to the file.
    if (happen('dragover') || happen('drop')) throw new Error('the drop is left to the browser');
    // Every opening creates a new list.
    while (window.sinew.problems === before) await new Promise((resolve) => setTimeout(resolve, 5));
  }, encoded);
}

export function setPose(page: Page, pose: PoseJson): Promise<PoseJson> {
  return page.evaluate((pose) => window.sinew.pose(pose), pose);
}

export function getPose(page: Page): Promise<PoseJson> {
  return page.evaluate(() => window.sinew.pose());
}

/** The posed positions, in the file's order and units. */
export async function vertices(page: Page, device: SkinDevice): Promise<Float32Array> {
  const blob = await page.evaluateHandle(
    (device) => new Blob([window.sinew.vertices(device) as Float32Array<ArrayBuffer>]),
    device,
  );
  const bytes = await bytesOf(blob);
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

export async function verify(page: Page): Promise<Verification> {
  const verification = await page.evaluate(() => window.sinew.verify());
  if (!verification) throw new Error('there is a character to verify');
  return verification;
}

/** In pixels. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** Captures the view, in its own size if none is given, and returns the file. */
export async function capture(
  page: Page,
  format: PictureFormat = 'png',
  size?: PictureSize,
  views?: readonly CaptureView[],
): Promise<Buffer> {
  const options = { format, ...size, ...(views && { views }) };
  return bytesOf(await page.evaluateHandle((options) => window.sinew.capture(options), options));
}

/** Reads a blob of the page through base64, which is many times faster than an array of numbers. */
export async function bytesOf(blob: JSHandle<Blob>): Promise<Buffer> {
  const url = await blob.evaluate(
    (blob) =>
      new Promise<string>((resolve) => {
        const reader = new FileReader();
        reader.onload = () => resolve(reader.result as string);
        reader.readAsDataURL(blob);
      }),
  );
  return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}

/** Runs an entry of the File menu. */
export async function chooseFromMenu(page: Page, name: string): Promise<void> {
  await page.getByRole('button', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name }).click();
}

/** The row with this name, in the controls or in one of their folders. */
export function controlRow(within: Page | Locator, name: string): Locator {
  return within.locator(`.lil-controller:has(.lil-name:text-is("${name}"))`);
}

/**
 * Chooses an option in a row of the controls, even if it is out of sight, and waits for the result.
 */
export async function choose(page: Page, row: string, option: string): Promise<void> {
  const select = controlRow(page, row).locator('select');
  for (const { id } of tabs) if ((await select.count()) === 0) await openTab(page, id);
  await select.selectOption({ label: option }, { force: true });
  await page.evaluate(() => window.sinew.settled());
}

/** Sets the selected character's method and normals to those of a kernel. */
export async function chooseKernel(page: Page, id: KernelId): Promise<void> {
  const { method, normals } = deformationOf(id);
  await choose(page, 'Method', menuName(methods.find((each) => each.id === method)!));
  await choose(page, 'Normals', normalWays.find((each) => each.id === normals)!.label);
}

/** Selects a joint and returns the row of one of its numbers, scrolled into view. */
export async function openJoint(page: Page, joint: string, name: string) {
  const field = page.locator(`input[aria-label="${joint} ${name}"]:visible`);
  if ((await field.count()) === 0) {
    await page.getByRole('treeitem', { name: joint, exact: true }).click();
  }
  await field.scrollIntoViewIfNeeded();
  const row = controlRow(page, name).filter({ has: field });
  return { field, slider: row.getByRole('slider'), row };
}
