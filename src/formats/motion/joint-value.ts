import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import type { AnimatedThing } from '../../core/motion/targets.ts';
import type { ChannelTarget } from '../../core/motion/clip-parts.ts';
import { ballValue } from '../ball-values.ts';
import type { JsonValue } from '../json/decoder.ts';
import { keyAt } from '../json/keys.ts';
import { nameIn, wordIn } from './fields.ts';
import { jointOf } from './find.ts';
import type { TargetKind } from './motion.ts';

const words = ['tx', 'ty', 'tz', 'rx', 'ry', 'rz'] as const;
type Word = (typeof words)[number];

/** One slide or hinge of a joint: `{"joint": NAME, "value": "rx"}`. */
export const jointValue: TargetKind = {
  fields: ['joint', 'value'],
  matches: (fields) => fields.has('joint') && fields.has('value'),

  read(fields) {
    const joint = nameIn(fields.get('joint')!, 'joint');
    const value = wordIn(fields.get('value')!, words);
    if (joint === undefined || value === undefined) return undefined;
    return {
      names: [`${joint}.${value}`],
      rotation: null,
      find: (thing, json) => find(thing, joint, value, json),
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'value') return undefined;
    const joint = skeleton.jointOfSource[target.joint];
    if (joint === undefined) return undefined;
    const value = words[(target.kind === DofKind.slide ? 0 : 3) + target.axis]!;
    return { joint: keyAt(skeleton.names, joint, target.joint), value };
  },
};

function find(
  { skeleton }: AnimatedThing,
  name: string,
  word: Word,
  json: JsonValue,
): ChannelTarget | undefined {
  const joint = jointOf(skeleton, name, json);
  if (joint === undefined) return undefined;
  const kind = word.startsWith('t') ? DofKind.slide : DofKind.hinge;
  const axis = 'xyz'.indexOf(word[1]!) as 0 | 1 | 2;
  const isThere = axisDofs(skeleton, joint).some(
    (each) => each.kind === kind && each.axis === axis,
  );
  if (isThere) return { of: 'value', joint: skeleton.sourceIndex[joint]!, kind, axis };
  reportMissing(skeleton, joint, word, json);
  return undefined;
}

function reportMissing(skeleton: Skeleton, joint: number, word: Word, json: JsonValue): void {
  const name = skeleton.names[joint]!;
  const place = json.member('value');
  if (word.startsWith('r') && ballValue(skeleton, joint) >= 0) {
    place.fail('token', `"rotation" for "${name}", which turns as a ball`, word);
    return;
  }
  const verb = word.startsWith('t') ? 'move along' : 'turn about';
  const expected = `no ${word} for "${name}", which does not ${verb} ${word[1]!}`;
  place.warn('ignored', expected, word, 'the channel moves nothing; it is kept for saving');
}
