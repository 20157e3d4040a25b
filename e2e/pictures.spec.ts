import type { PoseJson } from '../src/formats/pose-json.ts';
import { rigid } from '../src/skinning/rigid.ts';
import { capture, choose, openView, setPose } from './support/app.ts';
import { expectPicture } from './support/pictures.ts';
import { sharedPage, test } from './support/test.ts';

// Few pictures, each telling, each looked at before it was kept. UPDATE_PICTURES=1 makes them anew.
interface Scene {
  readonly query?: string;
  readonly dark?: boolean;
  readonly pose?: PoseJson;
  /** By its label in the controls. */
  readonly method?: string;
  /** Keys pressed, in order. */
  readonly keys?: readonly string[];
}

/** Bends as far as limbs go and farther, where linear blending shows its limits. */
const hardPose: PoseJson = {
  joints: {
    Spine: [0.5, 0.5, 0],
    Head: [-0.3, -0.6, 0],
    'Left upper arm': [0, -0.3, 0.9],
    'Left forearm': [0.4, -2.1, 0],
    'Right upper arm': [1.2, 0, -0.4],
    'Right forearm': [1.6, 0.6, 0],
    'Right hand': [0, 0, 1.2],
    'Left upper leg': [-1.4, 0, 0.2],
    'Left lower leg': [2, 0, 0],
    'Right upper leg': [-1.2, 0, -0.3],
    'Right lower leg': [2.2, 0, 0],
  },
};

const scenes: Readonly<Record<string, Scene>> = {
  'human-smooth': {},
  'human-dark': { dark: true },
  'human-faceted': { query: 'workspace=6.837' },
  'human-skeleton': { keys: ['s'] },
  'human-both': { keys: ['s', 's'] },
  'human-axes': { pose: {}, keys: ['s', 'a', 'ArrowRight', 'ArrowUp'] },
  'human-hard-pose': { pose: hardPose, keys: ['Home'] },
  'human-rigid': { pose: hardPose, method: rigid.label, keys: ['Home'] },
  'human-translucent': { keys: ['s', 's', 't'] },
  'hand-both': { query: 'model=hand', keys: ['s', 's'] },
  dog: { query: 'model=dog' },
  'tube-twisted': { query: 'model=tube' },
};

const page = sharedPage(() => Promise.resolve());

for (const [name, { query, dark = false, pose, method, keys = [] }] of Object.entries(scenes)) {
  test(name, async () => {
    await page().emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
    await openView(page(), query);
    if (pose) await setPose(page(), pose);
    if (method !== undefined) await choose(page(), 'Method', method);
    for (const key of keys) await page().keyboard.press(key);
    expectPicture(name, await capture(page()));
  });
}
