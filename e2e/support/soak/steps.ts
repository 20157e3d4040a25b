import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from '@playwright/test';
import { leg } from '../../../tests/support/cse169-files.ts';
import { catalogue } from '../catalogue.ts';
import { madeCharacter } from '../made-character.ts';
import { type FoundControl, findControl } from './find-control.ts';

/** Returns a random integer from 0 to less than the count. */
export type Dice = (count: number) => number;

/** An action of a user. */
export interface Step {
  readonly name: string;
  /** How often the step is chosen, relative to the others. */
  readonly weight: number;
  /** @returns what exactly was done, for the log */
  run(page: Page, dice: Dice): Promise<string>;
}

const pressed: Readonly<Record<string, string>> = {
  ...{ 'Ctrl/Cmd': 'Control', Esc: 'Escape', PAGEUP: 'PageUp', PAGEDOWN: 'PageDown' },
  ...{ '←': 'ArrowLeft', '→': 'ArrowRight', '↑': 'ArrowUp', '↓': 'ArrowDown' },
};
const keysPage = path.resolve(import.meta.dirname, '../../../docs/keys.md');
const keys = [
  ...Array.from(readFileSync(keysPage, 'utf8').matchAll(/^\| `(.+?)` +\|/gm), ([, key]) =>
    pressOf(key!),
  ),
  ...['Tab', 'Shift+Tab', 'Enter', 'Control+z', 'Control+z', 'Control+Shift+z'],
];

/**
 * The sizes of a phone, a tablet and windows; all are small, because the CPU draws the pictures.
 */
const sizes = [
  [760, 420],
  [390, 700],
  [700, 380],
  [1100, 500],
] as const;

const texts = [
  '0',
  '0.4',
  '-1.2',
  '45°',
  '1e9',
  '-1e-9',
  'joint',
  'leg x',
  'NaN',
  '',
  '12,5',
  '#4080c0',
];

/** What is dropped or chosen: characters, a part, a pose, and a file with errors. */
const drops: readonly (readonly { readonly name: string; readonly content: string }[])[] = [
  madeCharacter(5, 2),
  madeCharacter(30, 20),
  Object.entries(leg).map(([name, content]) => ({ name, content: content as string })),
  [{ name: 'leg.skel', content: leg['leg.skel'] as string }],
  [{ name: 'a.pose.json', content: '{"joints":{"#1":[0.3,-0.2,0.1]},"root":[0,0.1,0]}' }],
  [{ name: 'bad.obj', content: 'v 0 0\nf 1 2 9\n' }],
].map((files) => files.map(({ name, content }) => ({ name, content: String(content) })));

export const steps: readonly Step[] = [
  { name: 'key', weight: 8, run: pressKey },
  { name: 'control', weight: 12, run: useControl },
  { name: 'drag in the view', weight: 5, run: dragInView },
  { name: 'drag of a slider', weight: 4, run: dragSlider },
  { name: 'pose', weight: 2, run: setPose },
  { name: 'open', weight: 2, run: (page, dice) => openBundled(page, dice, 'open') },
  { name: 'add', weight: 2, run: (page, dice) => openBundled(page, dice, 'add') },
  { name: 'drop', weight: 2, run: dropFiles },
  { name: 'remove', weight: 1, run: removeSelected },
  { name: 'wheel', weight: 1, run: turnWheel },
  { name: 'resize', weight: 1, run: resize },
  { name: 'lose the context', weight: 1, run: loseContext },
];

/** Answers the file dialogs that controls open. */
export function answerFileDialogs(page: Page, dice: Dice): void {
  page.on('filechooser', (chooser) => {
    // A dialog that asks for a folder rejects files and stays unanswered.
    const files = drops[dice(drops.length)]!.map(({ name, content }) => ({
      name,
      mimeType: 'application/octet-stream',
      buffer: Buffer.from(content),
    }));
    void chooser.setFiles(files).catch(() => undefined);
  });
}

async function pressKey(page: Page, dice: Dice): Promise<string> {
  const key = keys[dice(keys.length)]!;
  await page.keyboard.press(key);
  return key;
}

/** The name of the key combination in Playwright. */
/** A key of docs/keys.md as Playwright names it. To load the commands instead would take seconds. */
function pressOf(key: string): string {
  const parts = key.split('+').map((part) => pressed[part] ?? part);
  return parts.map((part) => (part.length === 1 ? part.toLowerCase() : part)).join('+');
}

async function useControl(page: Page, dice: Dice): Promise<string> {
  const control = await findControl(page, dice(10_000));
  if (!control) return 'covered';
  const { kind, x, y } = control;
  if (kind === 'slide') return dragControl(page, dice, control);
  if (kind === 'select') return chooseOption(page, dice, control);
  await page.mouse.click(x, y, { clickCount: dice(8) === 0 ? 2 : 1 });
  if (kind === 'click') return control.name;
  const text = texts[dice(texts.length)]!;
  await page.keyboard.press('Control+a');
  await page.keyboard.type(text);
  const end = ['Enter', 'Tab', 'Escape', 'ArrowUp', 'Control+z'][dice(5)]!;
  await page.keyboard.press(end);
  return `${control.name}: "${text}" ${end}`;
}

/**
 * Chooses an option by its value, because the browser's list of options is not part of the page.
 */
async function chooseOption(page: Page, dice: Dice, control: FoundControl): Promise<string> {
  const { x, y, name } = control;
  const chosen = await page.evaluate(
    ({ x, y, number }) => {
      const select = document.elementFromPoint(x, y)?.closest('.lil-controller, select');
      const list = select instanceof HTMLSelectElement ? select : select?.querySelector('select');
      const option = list?.options[number % list.options.length];
      if (!list || !option) return 'nothing';
      list.value = option.value;
      list.dispatchEvent(new Event('input', { bubbles: true }));
      list.dispatchEvent(new Event('change', { bubbles: true }));
      return option.label;
    },
    { x, y, number: dice(100) },
  );
  return `${name.slice(0, 12)}: ${chosen}`;
}

async function dragSlider(page: Page, dice: Dice): Promise<string> {
  const control = await findControl(page, dice(10_000), 'slide');
  return control ? dragControl(page, dice, control) : 'covered';
}

async function dragControl(page: Page, dice: Dice, control: FoundControl): Promise<string> {
  const { x, y, width, name } = control;
  const to = x + ((dice(100) - 50) / 100) * width;
  return `${name}: ${await drag(page, dice, 'left', [x, y], [to, y])}`;
}

async function dragInView(page: Page, dice: Dice): Promise<string> {
  const box = await page.locator('canvas.scene').boundingBox();
  if (!box) return 'no view';
  const place = (): [number, number] => [
    box.x + (box.width * (5 + dice(90))) / 100,
    box.y + (box.height * (5 + dice(90))) / 100,
  ];
  const button = (['left', 'left', 'left', 'middle', 'right'] as const)[dice(5)]!;
  return `${button} ${await drag(page, dice, button, place(), place())}`;
}

/** Something else may happen between the press and the release. */
async function drag(
  page: Page,
  dice: Dice,
  button: 'left' | 'middle' | 'right',
  from: readonly [number, number],
  to: readonly [number, number],
): Promise<string> {
  const between = ['', '', '', 'Escape', 'Control+z', 'open', 'key', 'remove'][dice(8)]!;
  if (dice(4) === 0) await page.keyboard.down('Alt');
  await page.mouse.move(...from);
  await page.mouse.down({ button });
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, { steps: 2 });
  if (between === 'open') await openBundled(page, dice, 'open');
  else if (between === 'key') await pressKey(page, dice);
  else if (between === 'remove') await removeSelected(page);
  else if (between !== '') await page.keyboard.press(between);
  await page.mouse.move(...to, { steps: 2 });
  await page.mouse.up({ button });
  await page.keyboard.up('Alt');
  return `drag ${between}`;
}

function setPose(page: Page, dice: Dice): Promise<string> {
  return page.evaluate(
    ([joint, ...angles]) => {
      const selected = window.sinew.characters.find((each) => each.selected);
      const name = selected?.joints[joint! % selected.joints.length];
      if (name === undefined) return 'nobody';
      window.sinew.pose({ joints: { [name]: angles.map((each) => each / 50 - 1) as never } });
      return name;
    },
    [dice(1000), dice(100), dice(100), dice(100)],
  );
}

/** Waits for the opening, or lets the next step begin while the character is still being read. */
async function openBundled(page: Page, dice: Dice, way: 'open' | 'add'): Promise<string> {
  const { id } = catalogue[dice(catalogue.length)]!;
  const waits = dice(2) === 0;
  await page.evaluate(
    async ({ id, way, waits }) => {
      const opened = window.sinew[way](id);
      if (waits) await opened;
    },
    { id, way, waits },
  );
  return `${id}${waits ? '' : ', not waited for'}`;
}

async function dropFiles(page: Page, dice: Dice): Promise<string> {
  const files = drops[dice(drops.length)]!;
  await page.evaluate((files) => {
    const dataTransfer = new DataTransfer();
    for (const { name, content } of files) dataTransfer.items.add(new File([content], name));
    const view = document.querySelector('canvas')!;
    for (const type of ['dragenter', 'dragover', 'drop']) {
      view.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, files);
  return files.map(({ name }) => name).join(' ');
}

async function removeSelected(page: Page): Promise<string> {
  await page.evaluate(() => window.sinew.remove());
  return '';
}

async function turnWheel(page: Page, dice: Dice): Promise<string> {
  await page.mouse.move(380, 200);
  await page.mouse.wheel(0, dice(600) - 300);
  return '';
}

async function resize(page: Page, dice: Dice): Promise<string> {
  const [width, height] = sizes[dice(sizes.length)]!;
  await page.setViewportSize({ width, height });
  return `${width} × ${height}`;
}

/** Takes a few steps without the context, which is then restored. */
async function loseContext(page: Page, dice: Dice): Promise<string> {
  const extension = await page.evaluateHandle(async () => {
    const canvas = document.querySelector('canvas')!;
    const extension = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context');
    // The browser restores a context some time after it is asked to.
    if (!extension) return null;
    // Before the page has heard of the loss, the browser refuses to restore the context.
    await new Promise<void>((resolve) => {
      // It is removed by name, because the count of listeners does not see what `once` removes.
      const heard = (): void => {
        canvas.removeEventListener('webglcontextlost', heard);
        resolve();
      };
      canvas.addEventListener('webglcontextlost', heard);
      extension.loseContext();
    });
    return extension;
  });
  if (!(await extension.evaluate((each) => each !== null))) return 'still lost';
  const done: string[] = [];
  for (let i = dice(4); i > 0; i--) {
    const { name, run } = steps[dice(steps.length - 1)]!; // all steps except this one, the last
    done.push(`${name} ${await run(page, dice)}`);
  }
  await extension.evaluate((extension) => {
    extension?.restoreContext();
  });
  return done.join(', ');
}
