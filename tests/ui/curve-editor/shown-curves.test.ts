import { describe, expect, it } from 'vitest';
import type {
  ChannelParts,
  ClipParts,
  RotationChannelParts,
} from '../../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { plotLines } from '../../../src/ui/curve-editor/plot-lines.ts';
import { rotationCurvesOf, rotationPartAt } from '../../../src/ui/curve-editor/rotation-curves.ts';
import { shownCurves } from '../../../src/ui/curve-editor/shown-curves.ts';
import { readOne } from '../../support/files.ts';
import { clipOf, hinge, key } from './lines.ts';

const slide = {
  ...hinge(1, [key(0, 2)]),
  target: { of: 'value', joint: 0, kind: DofKind.slide, axis: 1 },
} as const;
const morph = { ...hinge(0, [key(0, 0)]), target: { of: 'morph', morph: 0 } } as const;
const pin = { ...hinge(0, [key(0, 0)]), target: { of: 'pin', joint: 1, value: 'z' } } as const;
const below = { ...hinge(2, [key(0, 0)]), target: { ...hinge(2, []).target!, joint: 1 } };
const unknown = { ...hinge(0, [key(0, 0)]), target: null };

/** About x by angles (radians) at whole seconds. */
function turning(angles: readonly number[], curve: 'slerp' | 'squad'): RotationChannelParts {
  const keys = angles.map((angle, time) => {
    const half = angle / 2;
    return { time, value: [Math.sin(half), 0, 0, Math.cos(half)] as const };
  });
  return {
    target: { of: 'rotation', joint: 0, curve },
    before: 'constant',
    after: 'constant',
    keys,
  };
}

describe('the list of curves', async () => {
  const skel = 'balljoint hip { balljoint knee { } }';
  const { skeleton } = await readOne({ 'a.skel': skel });
  const thing = { skeleton, morphs: [{ name: 'smile' }] };
  const channels: readonly ChannelParts[] = [morph, below, pin, hinge(0, []), slide];
  const clip: ClipParts = { ...clipOf(), channels: [...channels, unknown] };

  it('has slides before angles, each by joint, then pins and morphs, with colors of their axes', () => {
    const shown = shownCurves(clip, thing, { joints: null, morphs: true });
    expect(shown.map(({ name, color, isDotted }) => [name, color, isDotted])).toEqual([
      ['hip Move Y', 'y', true],
      ['hip X', 'x', false],
      ['knee Z', 'z', false],
      ['Pin of knee Z', 'z', true],
      ['smile', 'other-0', false],
    ]);
  });

  it('is that of the joints that are asked for', () => {
    const shown = shownCurves(clip, thing, { joints: [0], morphs: false });
    expect(shown.map(({ name }) => name)).toEqual(['hip Move Y', 'hip X']);
  });

  it('draws a rotation as three lines with keys in time and without slopes', () => {
    const rotation = turning([0, 1, 2], 'slerp');
    const shown = shownCurves({ ...clip, channels: [rotation] }, thing, {
      joints: null,
      morphs: true,
    });
    const lines = plotLines(shown, false);
    expect(lines.map(({ color }) => color)).toEqual(['x', 'y', 'z']);
    expect([...lines[0]!.times]).toEqual([0, 1, 2]);
    expect(lines.every(({ slopes }) => slopes === null)).toBe(true);
    expect(lines[0]!.valueAt(1.5)).toBeCloseTo(1.5, 6);
  });
});

describe('a rotation as a vector', () => {
  it('goes on past half a turn and past whole turns', () => {
    const angles = [0, 2, 4, 6, 8, 9.42];
    const curves = rotationCurvesOf(turning(angles, 'slerp'));
    angles.forEach((angle, time) => {
      expect(rotationPartAt(curves, 0, time)).toBeCloseTo(angle, 5);
      expect(rotationPartAt(curves, 1, time)).toBeCloseTo(0, 5);
    });
    expect(rotationPartAt(curves, 0, 99)).toBeCloseTo(9.42, 5);
  });
});
