import type { PoseJson } from '../src/formats/pose-json.ts';
import type { KernelId } from '../src/skinning/method.ts';
import { kernelById, menuName } from '../src/skinning/registry.ts';
import {
  capture,
  choose,
  openSmallView,
  type PictureSize,
  setPose,
  startOver,
} from './support/app.ts';
import { expectPicture } from './support/pictures.ts';
import { hardPose } from './support/poses.ts';
import { sharedPage, test } from './support/test.ts';

// There are few pictures. Each shows something that no other does, and a person looked at it before
// it was kept. UPDATE_PICTURES=1 regenerates them.
interface Scene {
  /** The bundled character; the human if absent. */
  readonly model?: string;
  /** The studio if absent. */
  readonly workspace?: string;
  readonly dark?: boolean;
  /** Characters added beside the first, in order; the last one is selected. */
  readonly added?: readonly string[];
  readonly pose?: PoseJson;
  /** The method's label in the controls. */
  readonly method?: string;
  readonly morphs?: Readonly<Record<string, number>>;
  /** The time of the character's clip, in seconds. */
  readonly time?: number;
  /** Labels of menus in the controls, and what to choose there, in order. */
  readonly menus?: Readonly<Record<string, string>>;
  /** The name of the joint to select. */
  readonly joint?: string;
  /** In pixels; 640 × 480 if absent. */
  readonly size?: PictureSize;
  /** Methods whose pictures stand side by side, from the left. */
  readonly compared?: readonly KernelId[];
  /** The keys to press, in order. */
  readonly keys?: readonly string[];
}

/** The view has the same aspect, and fewer pixels to draw while a scene is made. */
const usual = { width: 640, height: 480 };
/** The weights of a limb show at half the size. */
const half = { width: 240, height: 320 };
const weights = { pose: hardPose, size: half, keys: ['Home'] };

const fourMethods = {
  model: 'tube',
  compared: ['linear-blend', 'dual-quaternion', 'centers-of-rotation', 'delta-mush'],
  size: { width: 880, height: 320 },
  keys: ['Home'],
} as const;

// `npm run test:long -- pictures` makes those too of which others show each part.
const rare = new Set([
  ...[
    'human-skeleton',
    'human-both',
    'human-front',
    'human-hard-pose',
    'weights-count',
    'hand-both',
  ],
  ...['dog-low-sun', 'tube-twisted', 'four-methods-twist', 'insect-boxes-skin'],
]);
const isLong = process.env['PICTURES'] === 'all';

const scenes: Readonly<Record<string, Scene>> = {
  'human-smooth': {},
  'human-dark': { dark: true },
  'human-faceted': { workspace: '6.837' },
  'human-skeleton': { keys: ['s'] },
  'human-both': { keys: ['s', 's'] },
  'human-axes': { pose: {}, keys: ['s', 'a', 'ArrowRight', 'ArrowUp'] },
  'human-front': { keys: ['Home', 'a', '1'] },
  'human-hard-pose': { pose: hardPose, keys: ['Home'] },
  'human-rigid': { pose: hardPose, method: menuName(kernelById('rigid')), keys: ['Home'] },
  'human-translucent': { keys: ['s', 's', 't'] },
  'three-actors': { added: ['dog', 'insect'], time: 0.8, keys: ['s', 's', ']'] },
  'planar-shadow': { added: ['dog'], menus: { Preset: 'Noon' }, keys: ['Home'] },
  'weights-joints': { ...weights, menus: { 'Colors (v)': 'All joints' } },
  'weights-joint': { ...weights, menus: { 'Colors (v)': 'One joint' }, joint: 'Left upper arm' },
  'weights-count': { ...weights, menus: { 'Colors (v)': 'Number of influences' } },
  'weights-error': { ...weights, menus: { 'Keep influences': '2' } },
  'hand-both': { model: 'hand', keys: ['s', 's'] },
  dog: { model: 'dog' },
  'dog-low-sun': { model: 'dog', menus: { Preset: 'Low sun' } },
  'dog-mirrored': { model: 'dog', menus: { Preset: 'Back light' }, keys: ['s', 's'] },
  'tube-twisted': { model: 'tube' },
  'four-methods-twist': {
    ...fourMethods,
    pose: { joints: { '#2': [0, (150 * Math.PI) / 180, 0] } },
  },
  'four-methods-bend': {
    ...fourMethods,
    pose: { joints: { '#2': [(120 * Math.PI) / 180, 0, 0] } },
  },
  'insect-boxes': { model: 'insect', workspace: 'cse169' },
  'insect-boxes-skin': { model: 'insect', workspace: 'cse169', keys: ['s'] },
  'insect-textured': { model: 'insect' },
  'insect-morph': { model: 'insect', morphs: { insect_alert: 1, insect_breathe: 1 } },
  'insect-walk': {
    model: 'insect',
    time: 0.35,
    menus: { 'Skeleton as': 'Both' },
    keys: ['s', 's', 't'],
  },
};

const page = sharedPage(() => Promise.resolve());
/**
 * The character of the current address. Scenes with the same character follow each other and load
 * it once.
 */
let loaded = '';

for (const [name, scene] of Object.entries(scenes)) {
  if (rare.has(name) && !isLong) continue;
  const { model = 'human', workspace = 'studio', dark = false, added = [], keys = [] } = scene;
  const { pose, method, morphs, time, menus = {}, joint, size = usual, compared } = scene;
  test(name, async () => {
    await page().emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
    if (loaded !== model) await openSmallView(page(), `model=${model}`);
    loaded = model;
    await startOver(page(), workspace);
    for (const id of added) await page().evaluate((id) => window.sinew.add(id), id);
    if (pose) await setPose(page(), pose);
    if (method !== undefined) await choose(page(), 'Method', method);
    for (const [row, option] of Object.entries(menus)) await choose(page(), row, option);
    await page().evaluate(
      ({ morphs, time }) => {
        if (morphs) window.sinew.morphs(morphs);
        if (time !== undefined) window.sinew.seek(time);
      },
      { morphs, time },
    );
    if (joint !== undefined) {
      await page().locator('[role=treeitem]', { hasText: joint }).dispatchEvent('click');
    }
    for (const key of keys) await page().keyboard.press(key);
    const views = compared?.map((each) => ({ method: each }));
    expectPicture(name, await capture(page(), 'png', size, views));
  });
}
