import type { ScalarChannelParts, ScalarClipParts } from '../../core/motion/clip-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { DofKind } from '../../core/skeleton.ts';

/**
 * Assigns the channels of a clip by their order: the root's translation x, y, z, then the angles x,
 * y, z of every joint in the order of the skeleton's file. If the number of channels differs, those
 * that fit are used.
 */
export function bindChannels(clip: ScalarClipParts, jointCount: number): Parsed<ScalarClipParts> {
  const log = new DiagnosticLog(clip.file);
  const expectedCount = 3 * jointCount + 3;
  if (clip.channels.length !== expectedCount) {
    log.warn({
      code: 'anim/count',
      expected: `${expectedCount} channels, 3 for each of ${jointCount} joints and 3 for the root`,
      found: `${clip.channels.length}`,
      effect: 'the channels that fit are used, in order',
    });
  }
  const channels = clip.channels.map((channel, index) => ({
    ...channel,
    target: targetOf(index, jointCount),
  }));
  return log.finish({ ...clip, channels });
}

function targetOf(index: number, jointCount: number): ScalarChannelParts['target'] {
  const axis = (index % 3) as 0 | 1 | 2;
  if (index < 3) return { of: 'value', joint: 0, kind: DofKind.slide, axis };
  const joint = Math.floor(index / 3) - 1;
  return joint < jointCount ? { of: 'value', joint, kind: DofKind.hinge, axis } : null;
}
