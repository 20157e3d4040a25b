import { describe, expect, it } from 'vitest';
import type { Diagnostic } from '../../src/core/diagnostics.ts';
import { openCharacters } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { isMotionText, openMotion } from '../../src/ui/open-motion.ts';
import { legAnim, legSkel } from '../support/cse169-files.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { readOne } from '../support/files.ts';

const wave = {
  range: [0.5, 2.5],
  channels: [
    { target: { joint: 'knee', value: 'rx' }, keys: [[0, 1]] },
    { target: { joint: 'wing', value: 'rx' }, keys: [[0, 1]] },
    ...['x', 'y', 'z'].map((value, at) => ({ target: { pin: 'foot', value }, keys: [[0, at]] })),
    { target: { pin: 'hip', value: 'x' }, keys: [[0, 1]] },
  ],
};

async function sceneOf(skel = legSkel) {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const character = await readOne({ 'a.skel': skel });
  store.dispatch(openCharacters([], [{ character, method: 'linear-blend', kept: {} }]));
  const problems: Diagnostic[] = [];
  const open = (file: string, text: string): string =>
    openMotion({ store, session }, file, new TextEncoder().encode(text), problems);
  return { session, store, problems, open, actor: () => store.scene.value.actors[0]! };
}

describe('opening a motion', () => {
  it('binds it as one more clip at its start, in one step, with the pins that it moves', async () => {
    const { session, store, problems, open, actor } = await sceneOf();
    session.playing.value = true;
    const before = store.scene.value;
    const said = open('wave.motion.json', JSON.stringify(wave));
    expect(said).toBe('Motion wave opened: 5 channels, 2 s; Problems says what was not used');
    expect(problems.map(({ code, found, line, path }) => [code, found, line, path])).toEqual([
      ['motion/unknown-joint', 'wing', 1, 'channels[1].target.joint'],
      ['motion/missing', 'x', 1, 'channels[5].target.pin'],
    ]);
    const { clips, clip, pins, character } = actor();
    expect([clips.length, clip, clips[0]!.name, clips[0]!.unread?.length]).toEqual([
      1,
      0,
      'wave',
      1,
    ]);
    expect(pins).toEqual([
      {
        joint: character.skeleton.names.indexOf('foot'),
        point: [0, 0, 0],
        place: [0, 1, 2],
        rotation: null,
        weight: 1,
        follows: null,
      },
    ]);
    expect([session.playing.value, session.clipTime.value]).toEqual([false, 0.5]);
    store.undo();
    expect(store.scene.value).toBe(before);
  });

  it('gives a second one of a name another name', async () => {
    const { open, actor } = await sceneOf();
    for (let i = 0; i < 2; i++)
      open('wave.json', JSON.stringify({ channels: wave.channels.slice(0, 1) }));
    expect(actor().clips.map(({ name }) => name)).toEqual(['wave', 'wave 2']);
    expect(actor().clip).toBe(1);
  });

  it('opens an .anim for a character with as many channels', async () => {
    const { open, actor, problems } = await sceneOf();
    expect(open('kick.anim', legAnim)).toMatch(/^Motion kick opened: 12 channels/);
    expect(problems).toEqual([]);
    expect(actor().clip).toBe(0);
    const other = await sceneOf(courseSkel);
    expect(other.open('kick.anim', legAnim)).toContain('it has 12 channels, not 57 as for a');
    expect(other.actor().clips).toEqual([]);
  });

  it('opens nothing where no channel can be used', async () => {
    const { store, open } = await sceneOf();
    const before = store.scene.value;
    const text = JSON.stringify({ channels: wave.channels.slice(1, 2) });
    expect(open('a.json', text)).toBe('The motion was not opened; Problems says why');
    expect(open('a.json', '{')).toBe('The motion was not opened; Problems says why');
    expect(store.scene.value).toBe(before);
  });

  it('needs a character', () => {
    const session = new Session();
    const store = new Store((before, after) => reconcile(session, before, after));
    expect(openMotion({ store, session }, 'a.json', new Uint8Array(0), [])).toContain(
      'no character',
    );
  });
});

describe('a JSON text', () => {
  it('is a motion if it has channels', () => {
    expect(isMotionText(JSON.stringify(wave))).toBe(true);
    expect(isMotionText('{"channels": [{"target": {"joints": ["a"]}, "keys": []}]}')).toBe(true);
    expect(isMotionText('{"joints": {"channels": [0, 0, 0]}}')).toBe(false);
    expect(isMotionText('{"root": [0, 0, 0]}')).toBe(false);
  });
});
