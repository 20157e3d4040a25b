import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { readBoundMotion } from '../../../src/formats/motion/read-bound-motion.ts';
import { legSkel } from '../../support/cse169-files.ts';
import { readOne } from '../../support/files.ts';
import { type Matrix, multiply, rotationAbout } from '../../reference/matrix.ts';

const one = await readOne({ 'a.skel': '0 0 0 -1\n0 1 0 0\n' });
const leg = await readOne({ 'leg.skel': legSkel });

/** An `.anim` for two joints; only the first one turns, by linear curves from 0 to the angles. */
function anim([x, y, z]: readonly number[], joints = 2): Uint8Array {
  const channel = (end: number): string =>
    `channel { extrapolate cycle constant keys 2 { 0 0 linear linear\n 1 ${end} linear linear } }`;
  const still = 'channel { extrapolate constant constant keys 1 { 0 0 flat flat } }';
  const channels = [still, still, still, channel(x!), channel(y!), channel(z!)];
  while (channels.length < 3 + 3 * joints) channels.push(still);
  const text = `animation { range 0 1 numchannels ${channels.length} ${channels.join('\n')} }`;
  return new TextEncoder().encode(text);
}

/** Rz · Ry · Rx of a part of the angles, which is what an `.anim` says. */
function meant(part: number, [x, y, z]: readonly number[]): Matrix {
  const about = (axis: readonly number[], angle: number) => rotationAbout(axis, angle * part);
  return multiply(multiply(about([0, 0, 1], z!), about([0, 1, 0], y!)), about([1, 0, 0], x!));
}

describe('an .anim on joints that turn by Rx · Ry · Rz', () => {
  const angles = [0.9, -0.7, 2.1];
  const read = readBoundMotion('turn.anim', anim(angles), one);

  it.each([0, 1 / 24, 0.25, 0.5, 0.77, 1, 3, -0.25])('turns them as it says at %s s', (time) => {
    const q = one.skeleton.qRest.slice();
    const values = { q, morphWeights: new Float64Array(0), pins: new Float64Array(8) };
    evaluateClip(clipFor(read.value!, one), time, values);
    const matrix = jointMatrices(one.skeleton, q);
    const part = time < 0 ? time + 1 : Math.min(time, 1);
    const turned = meant(part, angles);
    for (const row of [0, 1, 2]) {
      for (const column of [0, 1, 2]) {
        expect(matrix[column * 4 + row]).toBeCloseTo(turned[row]![column]!, 3);
      }
    }
  });

  it('is told, with the largest difference', () => {
    expect(read.diagnostics).toMatchObject([
      { code: 'anim/order', severity: 'warning', found: '1 that turn in another order' },
    ]);
    expect(read.diagnostics[0]!.effect).toMatch(/off by at most [\d.e-]+° between/);
  });

  it('stays as it is where joints turn about one axis, which every order does alike', () => {
    const { value, diagnostics } = readBoundMotion('turn.anim', anim([0, 1, 0]), one);
    expect(diagnostics).toEqual([]);
    expect(value!.channels[4]!.keys).toHaveLength(2);
  });
});

it('stays as it is on the joints of its own course', () => {
  const { jointCount } = leg.skeleton;
  const { value, diagnostics } = readBoundMotion('turn.anim', anim([1, 1, 1], jointCount), leg);
  expect(diagnostics.filter(({ code }) => code === 'anim/order')).toEqual([]);
  expect(value!.channels[3]!.keys).toHaveLength(2);
});
