import type {
  ChannelParts,
  ClipParts,
  KeyParts,
  ScalarTarget,
} from '../../../src/core/motion/clip-parts.ts';
import type { AnimatedThing } from '../../../src/core/motion/targets.ts';
import { DofKind } from '../../../src/core/skeleton.ts';
import { readOne } from '../../support/files.ts';

/** A hip with a thigh, a shin and a tail; every joint turns about three axes. */
export async function legs(): Promise<AnimatedThing> {
  const skeleton = `balljoint hip {
    balljoint thigh { offset 0 -1 0 balljoint shin { offset 0 -1 0 } }
    balljoint tail { offset 0 0 -1 }
  }`;
  const character = await readOne({ 'legs.skel': skeleton });
  return { skeleton: character.skeleton, morphs: [{ name: 'smile' }] };
}

export const turn = (joint: number, axis: 0 | 1 | 2): ScalarTarget => ({
  of: 'value',
  ...{ joint, axis, kind: DofKind.hinge },
});

export function key(time: number, value: number): KeyParts {
  return { time, value, tangentIn: 'auto', tangentOut: 'auto' };
}

/** A channel with keys at some times, of values that differ unless they are given. */
export function channel(
  target: ScalarTarget,
  times: readonly number[],
  values: readonly number[] = times,
): ChannelParts {
  const keys = times.map((time, at) => key(time, values[at]!));
  return { target, before: 'constant', after: 'constant', keys };
}

export function clipOf(channels: readonly ChannelParts[]): ClipParts {
  return { file: 'a.anim', name: 'a', start: 0, end: 2, fps: 30, channels };
}
