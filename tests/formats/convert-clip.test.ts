import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import type { ChannelParts, ClipParts, Extrapolation } from '../../src/core/motion/clip-parts.ts';
import type { Character } from '../../src/core/character.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { type Converted, convertCharacter } from '../../src/formats/convert.ts';
import type { ConvertTarget } from '../../src/formats/registry.ts';
import { legSkel, legSkin } from '../support/cse169-files.ts';
import { inverse, type Matrix, multiply, transpose } from '../reference/matrix.ts';
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

/** The turn of the foot since rest, in the character's space, at a time of a clip. */
function turnOfFoot(character: Character, q: Float64Array, clip: ClipParts, time: number): Matrix {
  const { skeleton, morphs } = character;
  const values = {
    q: q.slice(),
    morphWeights: new Float64Array(morphs.length),
    pins: new Float64Array(skeleton.jointCount * 4),
  };
  evaluateClip(clipFor(clip, character), time, values);
  const foot = skeleton.jointOfSource.at(-1)!;
  const [now, rest] = [values.q, skeleton.qRest].map((pose) =>
    rows(jointMatrices(skeleton, pose), foot),
  );
  return multiply(now!, inverse(rest!));
}

function rows(matrices: Float64Array, joint: number): Matrix {
  return [0, 1, 2, 3].map((row) =>
    [0, 1, 2, 3].map((column) => matrices[joint * 16 + column * 4 + row]!),
  );
}

/** In radians. */
function angleBetween(a: Matrix, b: Matrix): number {
  const turn = multiply(transpose(a), b);
  // Exact for small angles, unlike the arc cosine of the trace.
  const sine =
    Math.hypot(
      turn[2]![1]! - turn[1]![2]!,
      turn[0]![2]! - turn[2]![0]!,
      turn[1]![0]! - turn[0]![1]!,
    ) / 2;
  return Math.atan2(sine, (turn[0]![0]! + turn[1]![1]! + turn[2]![2]! - 1) / 2);
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

  it.each(['mit', 'mmd'] as const)('says how far rotations of %s are off at most', (to) => {
    const clip = clipOf(angle(2, 0), angle(2, 1), angle(2, 2));
    const { character, pose, convertClip } = convertCharacter(leg, to, { q: leg.skeleton.qRest });
    const { clip: moved, losses } = convertClip(clip);
    const dense = Array.from({ length: 60 * 64 }, (_, step) => {
      const time = step / (60 * 64);
      const before = turnOfFoot(leg, leg.skeleton.qRest, clip, time);
      return angleBetween(before, turnOfFoot(character, pose.q, moved, time));
    });
    const largest = (Math.max(...dense) * 180) / Math.PI;
    const told = Number(/off by at most ([\d.e-]+)°/.exec(losses[0]!.effect)![1]);
    expect(told).toBeGreaterThanOrEqual(largest);
    // It has two digits, rounded up.
    expect(told).toBeLessThan(largest * 1.12);
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
