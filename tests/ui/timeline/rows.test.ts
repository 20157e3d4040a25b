import { describe, expect, it } from 'vitest';
import { type RowChoices, timelineRows } from '../../../src/ui/timeline/rows.ts';
import { channel, clipOf, legs, turn } from './clip.ts';

const plain: RowChoices = { turned: new Set(), allJoints: false, selected: [] };
const [hip, thigh, shin, tail] = [0, 1, 2, 3];
const clip = clipOf([
  channel(turn(hip, 1), [0, 1]),
  channel(turn(shin, 2), [0, 2]),
  channel(turn(shin, 0), [0.5]),
  channel({ of: 'morph', morph: 0 }, [1]),
  channel({ of: 'pin', joint: tail, value: 'weight' }, [0]),
  channel({ of: 'pin', joint: tail, value: 'x' }, [0]),
]);

async function rowsOf(choices: Partial<RowChoices>) {
  return timelineRows(clip, await legs(), { ...plain, ...choices });
}
const told = async (choices: Partial<RowChoices>) =>
  (await rowsOf(choices)).map(({ level, label }) => `${level} ${label}`);

describe('the rows of the timeline', () => {
  it('are a summary, the joints that the clip moves, morphs and pins', async () => {
    expect(await told({})).toEqual(['1 All', '1 hip', '2 shin', '1 Morphs', '1 Pins']);
    const [all] = await rowsOf({});
    expect(all!.channels).toHaveLength(6);
  });

  it('are those of all joints by choice, each below its parent', async () => {
    const rows = await told({ allJoints: true });
    expect(rows.slice(1, 5)).toEqual(['1 hip', '2 thigh', '3 shin', '2 tail']);
  });

  it('begin with the selected joints, unfolded to their values by axis', async () => {
    const rows = await rowsOf({ selected: [shin, thigh] });
    expect(rows.slice(1, 6).map(({ id, fullName }) => [id.slice(0, 10), fullName])).toEqual([
      ['selected 2', 'shin'],
      ['selected 2', 'shin X'],
      ['selected 2', 'shin Z'],
      ['selected 1', 'thigh'],
      ['joint 0', 'hip'],
    ]);
    expect(rows[2]).toMatchObject({ kind: 'channel', axis: 'x', joint: shin, level: 2 });
  });

  it('of a folded branch have the keys of all that it hides', async () => {
    const rows = await rowsOf({ turned: new Set(['branch joint 0']) });
    expect(rows.map(({ label }) => label)).toEqual(['All', 'hip', 'Morphs', 'Pins']);
    expect(rows[1]).toMatchObject({ showsBranch: false, showsChannels: null });
    expect(rows[1]!.channels).toHaveLength(3);
    const [, open] = await rowsOf({});
    expect(open).toMatchObject({ showsBranch: true, showsChannels: false });
    expect(open!.channels).toHaveLength(1);
  });

  it('of pins and morphs unfold to values that say whose they are', async () => {
    const rows = await rowsOf({ turned: new Set(['channels pin', 'channels morph']) });
    expect(rows.slice(3).map(({ fullName }) => fullName)).toEqual([
      'Morphs',
      'smile',
      'Pins',
      'Pin of tail X',
      'Pin of tail weight',
    ]);
  });
});
