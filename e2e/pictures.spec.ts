import type { PoseJson } from '../src/formats/pose-json.ts';
import { kernelById, menuName } from '../src/skinning/registry.ts';
import { capture, choose, openView, setPose, startOver } from './support/app.ts';
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
  /** Labels of menus of the light and the floor, and what to choose there, in order. */
  readonly surroundings?: Readonly<Record<string, string>>;
  /** The label of the skeleton's style in the controls. */
  readonly skeletonAs?: string;
  /** The keys to press, in order. */
  readonly keys?: readonly string[];
}

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
  'two-methods': { pose: hardPose, keys: ['Home', 'x'] },
  'three-actors': { added: ['dog', 'insect'], time: 0.8, keys: ['s', 's', ']'] },
  'planar-shadow': { added: ['dog'], surroundings: { Preset: 'Noon' }, keys: ['Home'] },
  'hand-both': { model: 'hand', keys: ['s', 's'] },
  dog: { model: 'dog' },
  'dog-low-sun': { model: 'dog', surroundings: { Preset: 'Low sun' } },
  'dog-mirrored': { model: 'dog', surroundings: { Preset: 'Back light' }, keys: ['s', 's'] },
  'tube-twisted': { model: 'tube' },
  'insect-boxes': { model: 'insect', workspace: 'cse169' },
  'insect-boxes-skin': { model: 'insect', workspace: 'cse169', keys: ['s'] },
  'insect-textured': { model: 'insect' },
  'insect-morph': { model: 'insect', morphs: { insect_alert: 1, insect_breathe: 1 } },
  'insect-walk-1': { model: 'insect', time: 0.35, skeletonAs: 'Both', keys: ['s', 's', 't'] },
  'insect-walk-2': { model: 'insect', time: 0.8 },
  'insect-walk-3': { model: 'insect', time: 1.25 },
};

const page = sharedPage(() => Promise.resolve());
/**
 * The character of the current address. Scenes with the same character follow each other and load
 * it once.
 */
let loaded = '';

for (const [name, scene] of Object.entries(scenes)) {
  const { model = 'human', workspace = 'studio', dark = false, added = [], keys = [] } = scene;
  const { pose, method, morphs, time, skeletonAs, surroundings = {} } = scene;
  test(name, async () => {
    await page().emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
    if (loaded !== model) await openView(page(), `model=${model}`);
    loaded = model;
    await startOver(page(), workspace);
    for (const id of added) await page().evaluate((id) => window.sinew.add(id), id);
    if (pose) await setPose(page(), pose);
    if (method !== undefined) await choose(page(), 'Method', method);
    if (skeletonAs !== undefined) await choose(page(), 'Skeleton as', skeletonAs);
    await page().evaluate(
      ({ morphs, time }) => {
        if (morphs) window.sinew.morphs(morphs);
        if (time !== undefined) window.sinew.seek(time);
      },
      { morphs, time },
    );
    for (const [row, option] of Object.entries(surroundings)) await choose(page(), row, option);
    for (const key of keys) await page().keyboard.press(key);
    expectPicture(name, await capture(page()));
  });
}
