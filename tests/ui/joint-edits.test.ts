import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { BallAngles } from '../../src/document/ball-angles.ts';
import { valueIn, withValue } from '../../src/ui/joint-edits.ts';
import { jointValues } from '../../src/ui/joint-values.ts';
import { readOne } from '../support/files.ts';

/** Three joints of three hinges; the last one has limits about x. */
const skel = `balljoint root { offset 0 0 0
  balljoint middle { offset 0 1 0
    balljoint end { offset 0 1 0 rotxlimit -0.2 0.3 }
  }
}`;
const angle = fc.double({ min: -1, max: 1, noNaN: true });

describe('a number of several joints', () => {
  it('changes by as much in each, within its limits, and nothing else does', async () => {
    const { skeleton } = await readOne({ 'a.skel': skel });
    const angles = { ballAngles: new BallAngles() };
    fc.assert(
      fc.property(fc.nat(2), angle, angle, (axis, from, to) => {
        const q = skeleton.qRest.slice();
        const value = jointValues(skeleton, 0).find((each) => each.isAngle && each.axis === axis)!;
        q[value.index] = from;
        const next = withValue(angles, skeleton, q, [0, 1, 2], value, to);
        expect(next[value.index]).toBe(to);
        for (const joint of [1, 2]) {
          for (const each of jointValues(skeleton, joint)) {
            const change =
              valueIn(angles, skeleton, next, each) - valueIn(angles, skeleton, q, each);
            const isSame = each.isAngle && each.axis === axis;
            const isLimited = joint === 2 && axis === 0;
            const wanted = isLimited ? Math.min(Math.max(to - from, -0.2), 0.3) : to - from;
            expect(change).toBeCloseTo(isSame ? wanted : 0, 12);
          }
        }
        const alone = q.slice();
        alone[value.index] = to;
        expect(withValue(angles, skeleton, q, [0], value, to)).toEqual(alone);
      }),
    );
  });
});
