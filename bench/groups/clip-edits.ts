import type { Character } from '../../src/core/character.ts';
import type { ClipParts, ScalarChannelParts } from '../../src/core/motion/clip-parts.ts';
import { clipFor, type ClipValues, evaluateClip } from '../../src/core/motion/clip.ts';
import { moveKeys } from '../../src/core/motion/edit/move-keys.ts';
import { channelKey } from '../../src/core/motion/targets.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { skeletonOf, triple } from '../../tests/posing/ik/ik-rigs.ts';
import { type BenchOptions, expectRight, type GroupResult } from '../harness/group.ts';
import { contenderOf, measure } from '../harness/measure.ts';
import { spreadOf } from '../harness/statistics.ts';

const jointCount = 100;
const keyCount = 1000;
/** Between two keys, in seconds. */
const gap = 1 / 30;

/** A step of dragging a key in a long clip: the edit, what compiles again, and one evaluation. */
export async function clipEdits({ rounds }: BenchOptions): Promise<GroupResult> {
  const edits = editsOfKeys();
  for (let index = 0; index < 2 * edits.channelCount; index++) {
    const { wanted, found } = edits.run(index);
    expectRight(Math.abs(wanted - found) < 1e-9, 'a moved key is not on its curve');
  }
  const samples = await measure([contenderOf('edit', edits.run)], rounds);
  const { lower, median, upper } = spreadOf(samples['edit']!.map(({ wall }) => wall));
  return {
    samples,
    values: { 'clip-edit': { value: median, lower, upper } },
    counts: { channels: edits.channelCount, keys: edits.channelCount * keyCount },
  };
}

function editsOfKeys() {
  const skeleton = skeletonOf(
    Array.from({ length: jointCount }, (_, joint) => [joint - 1, [0, 1, 0], triple()] as const),
  );
  const thing: Pick<Character, 'skeleton' | 'morphs'> = { skeleton, morphs: [] };
  const values: ClipValues = {
    q: skeleton.qRest.slice(),
    morphWeights: new Float64Array(0),
    pins: new Float64Array(0),
  };
  let clip = longClip();
  const { length: channelCount } = clip.channels;
  const valueAt = (time: number, channel: number): number => {
    const compiled = clipFor(clip, thing);
    evaluateClip(compiled, time, values);
    return values.q[compiled.curves.q[channel]!.index]!;
  };
  return { channelCount, run };

  /** Moves one key of one curve up or down, another one each time. */
  function run(index: number): { readonly wanted: number; readonly found: number } {
    const at = index % channelCount;
    const { target, keys } = clip.channels[at] as ScalarChannelParts;
    const key = keys[(index * 37) % keyCount]!;
    const value = index % 2 === 0 ? 0.3 : -0.3;
    const selection = new Map([[channelKey(target!), [key.time]]]);
    clip = moveKeys(clip, selection, { seconds: 0, value }).clip;
    return { wanted: key.value + value, found: valueAt(key.time, at) };
  }
}

function longClip(): ClipParts {
  const channels = Array.from({ length: jointCount * 3 }, (_, at): ScalarChannelParts => {
    const joint = Math.floor(at / 3);
    const axis = (at % 3) as 0 | 1 | 2;
    return {
      target: { of: 'value', joint, kind: DofKind.hinge, axis },
      ...{ before: 'constant', after: 'constant' },
      keys: Array.from({ length: keyCount }, (_, key) => ({
        ...{ time: key * gap, value: Math.sin(0.1 * key + at) },
        ...{ tangentIn: 'auto', tangentOut: 'auto' },
      })),
    };
  });
  return { file: 'long', name: 'long', start: 0, end: keyCount * gap, fps: 30, channels };
}
