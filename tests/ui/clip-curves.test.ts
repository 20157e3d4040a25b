import { describe, expect, it } from 'vitest';
import { clipFor } from '../../src/core/motion/clip.ts';
import { clipCurves } from '../../src/ui/clip-curves.ts';
import { readOne } from '../support/files.ts';

const still = 'channel { extrapolate constant constant keys 1 { 0 0 linear linear } }';
const anim = `animation { range 0 2 numchannels 6
  ${still} ${still} ${still}
  channel { extrapolate linear linear keys 3 { -1 -3 linear linear 0 0 linear linear 1 3 linear linear } }
  ${still}
  channel { extrapolate constant constant keys 2 { 0 0 flat flat 2 1 flat flat } } }`;

describe('the curves of a clip', () => {
  it('are those of a joint, moves before turns, by axis, each kind to its own scale', async () => {
    const character = await readOne({ 'a.skel': 'balljoint a { }', 'a.anim': anim });
    const { skeleton, clips } = character;
    const curves = clipCurves(clipFor(clips[0]!, character), skeleton, 0);
    expect(curves.map(({ name, axis }) => [name, axis])).toEqual([
      ['Move X', 'x'],
      ['Move Y', 'y'],
      ['Move Z', 'z'],
      ['X', 'x'],
      ['Y', 'y'],
      ['Z', 'z'],
    ]);
    const [turnX, , turnZ] = curves.slice(3);
    // From 0 to 6 over the range; the line continues past its last key.
    expect(turnX!.samples[0]).toEqual({ time: 0, part: 0 });
    expect(turnX!.samples.at(-1)).toEqual({ time: 2, part: 1 });
    expect(turnX!.keys).toEqual([
      { time: 0, part: 0 },
      { time: 1, part: 0.5 },
    ]);
    expect(turnZ!.samples.at(-1)!.part).toBeCloseTo(1 / 6, 12);
  });

  it('are none without a joint', async () => {
    const character = await readOne({ 'a.skel': 'balljoint a { }', 'a.anim': anim });
    const { skeleton, clips } = character;
    expect(clipCurves(clipFor(clips[0]!, character), skeleton, -1)).toEqual([]);
  });
});
