import { describe, expect, it } from 'vitest';
import { clipFor, evaluateClip } from '../../../src/core/motion/clip.ts';
import { axisDofs } from '../../../src/core/pose.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { readBoundMotion } from '../../../src/formats/motion/read-bound-motion.ts';
import { bytesOf, readOne } from '../../support/files.ts';

/** Two branches, so that the order of the file is neither that of the names nor by depth. */
const tree = await readOne({
  'tree.skel': `balljoint zebra {
    balljoint left { offset 1 0 0 balljoint hand { offset 1 0 0 } }
    balljoint ape { offset -1 0 0 balljoint foot { offset 0 -1 0 } }
  }`,
});
const order = ['zebra', 'left', 'hand', 'ape', 'foot'];

/** A clip whose channel number `n` is always n / 8. */
function numbered(count: number) {
  const channel = (at: number): string =>
    `channel { extrapolate constant constant keys 1 { 0 ${at / 8} flat flat } }`;
  const channels = Array.from({ length: count }, (_, at) => channel(at)).join('\n');
  const text = `animation { range 0 1 numchannels ${count} ${channels} }`;
  const { value, diagnostics } = readBoundMotion('n.anim', bytesOf(text), tree);
  const q = new Float64Array(tree.skeleton.qRest.length).fill(-1);
  const values = { q, morphWeights: new Float64Array(0), pins: new Float64Array(0) };
  evaluateClip(clipFor(value!, tree), 0.5, values);
  return { q, messages: diagnostics.map(({ code, found }) => [code, found]) };
}

/** The number of the channel that moves a value of a joint, or -1. */
function numberOf(q: Float64Array, name: string, kind: number, axis: number): number {
  const dofs = axisDofs(tree.skeleton, tree.skeleton.names.indexOf(name));
  const { index } = dofs.find((dof) => dof.kind === kind && dof.axis === axis)!;
  return q[index]! < 0 ? -1 : q[index]! * 8;
}

const anglesOf = (q: Float64Array) =>
  order.flatMap((name) => [0, 1, 2].map((axis) => numberOf(q, name, DofKind.hinge, axis)));

describe('the channels of an .anim', () => {
  it('are the translation of the root, then x, y, z of each joint in the order of the file', () => {
    const { q, messages } = numbered(18);
    expect(messages).toEqual([]);
    expect([0, 1, 2].map((axis) => numberOf(q, 'zebra', DofKind.slide, axis))).toEqual([0, 1, 2]);
    expect(anglesOf(q)).toEqual(Array.from({ length: 15 }, (_, at) => at + 3));
  });

  it('move what they fit where there are fewer or more, which is said', () => {
    const few = numbered(10);
    expect(few.messages).toEqual([['anim/count', '10']]);
    expect(anglesOf(few.q).slice(0, 9)).toEqual([3, 4, 5, 6, 7, 8, 9, -1, -1]);
    const many = numbered(20);
    expect(many.messages).toEqual([['anim/count', '20']]);
    expect(anglesOf(many.q).at(-1)).toBe(17);
  });
});
