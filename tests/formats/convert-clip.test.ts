import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import type { ChannelParts, ClipParts, Extrapolation } from '../../src/core/motion/clip-parts.ts';
import type { Character } from '../../src/core/character.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { type Converted, convertCharacter } from '../../src/formats/convert.ts';
import type { ConvertTarget } from '../../src/formats/registry.ts';
import { legSkel, legSkin } from '../support/cse169-files.ts';
import { readOne } from '../support/files.ts';

// Without a skin, whose bindings may put joints elsewhere.
const leg = await readOne({ 'a.skel': legSkel });
const bound = await readOne({ 'a.skel': legSkel, 'a.skin': legSkin });

function angle(joint: number, axis: 0 | 1 | 2, rule: Extrapolation = 'constant'): ChannelParts {
  const rest = leg.skeleton.qRest[3 + joint * 3 + (2 - axis)]!;
  return {
    target: { of: 'value', joint, kind: DofKind.hinge, axis },
    before: rule,
    after: rule,
    keys: [0, 0.4, 1].map((time, at) => ({
      time,
      value: rest + Math.sin(at + axis) * 0.6,
      tangentIn: 'auto' as const,
      tangentOut: 'auto' as const,
    })),
  };
}

const slide: ChannelParts = {
  ...angle(0, 0),
  target: { of: 'value', joint: 0, kind: DofKind.slide, axis: 1 },
} as ChannelParts;

function clipOf(...channels: readonly ChannelParts[]): ClipParts {
  return { file: 'a.json', name: 'bend', start: 0, end: 1, fps: 60, channels };
}

/** (jointCount × 3) where the joints are at a time of a clip, in the order of the file. */
function places(character: Character, q: Float64Array, clip: ClipParts, time: number): number[] {
  const values = {
    q: q.slice(),
    morphWeights: new Float64Array(character.morphs.length),
    pins: new Float64Array(character.skeleton.jointCount * 4),
  };
  evaluateClip(clipFor(clip, character), time, values);
  const { skeleton } = character;
  const matrices = jointMatrices(skeleton, values.q);
  return Array.from(skeleton.jointOfSource).flatMap((joint) => [
    ...matrices.subarray(joint * 16 + 12, joint * 16 + 15),
  ]);
}

function differences(to: ConvertTarget, clip: ClipParts, times: readonly number[]) {
  const q = leg.skeleton.qRest;
  const converted: Converted = convertCharacter(leg, to, { q });
  const moved = converted.convertClip(clip);
  const farthest = times.map((time) => {
    const before = places(leg, q, clip, time);
    const after = places(converted.character, converted.pose.q, moved.clip, time);
    // A root may have been put before the others.
    const own = after.slice(after.length - before.length);
    return Math.max(...before.map((value, i) => Math.abs(value - own[i]!)));
  });
  return { largest: Math.max(...farthest), ...moved };
}

const frames = Array.from({ length: 61 }, (_, frame) => frame / 60);
const between = frames.map((time) => time + 1 / 180);

describe('a clip of a converted character', () => {
  const whole = clipOf(slide, angle(0, 0), angle(0, 2), angle(1, 1), angle(1, 2));

  it.each(['mit', 'mmd'] as const)('moves the joints of %s to the same places', (to) => {
    expect(differences(to, whole, frames).largest).toBeLessThan(1e-6);
    const { largest, losses } = differences(to, whole, between);
    expect(largest).toBeLessThan(2e-3);
    expect(losses.map(({ found }) => found)).toEqual(['2 joints with others']);
    expect(losses[0]!.effect).toMatch(/sampled at 60 frames a second and .* at most [\d.e-]+°/);
  });

  it('keeps a rule that all joints have', () => {
    const cycled = clipOf(angle(0, 0, 'cycle'), angle(1, 1, 'cycle'));
    const outside = [-1.5, 1.25, 4.75];
    expect(differences('mit', cycled, outside).largest).toBeLessThan(1e-6);
  });

  it('holds the ends, and says so, where joints have several rules', () => {
    const mixed = clipOf(angle(0, 0, 'cycle'), angle(1, 1, 'linear'));
    const { clip, losses } = differences('mit', mixed, []);
    expect(
      clip.channels.every(({ before, after }) => before === after && after === 'constant'),
    ).toBe(true);
    expect(losses.map(({ effect }) => effect)).toContain('the first and the last value hold');
  });

  it('keeps pins at their joints, and what could not be read', () => {
    const pin: ChannelParts = {
      ...angle(0, 0),
      target: { of: 'pin', joint: 2, value: 'x' },
    } as ChannelParts;
    // This one gets a root before the others.
    const { convertClip } = convertCharacter(bound, 'mit', { q: bound.skeleton.qRest });
    const { clip } = convertClip({ ...clipOf(pin), unread: [{ a: 1 }] });
    expect(clip.channels[0]!.target).toEqual({ of: 'pin', joint: 3, value: 'x' });
    expect(clip.unread).toEqual([{ a: 1 }]);
  });

  it('refuses a motion of more frames than can be sampled', () => {
    const long = { ...clipOf(angle(0, 0), angle(1, 0, 'linear')), end: 1e9 };
    expect(differences('mit', long, []).losses).toMatchObject([{ severity: 'error' }]);
  });
});
