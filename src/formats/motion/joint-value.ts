import { axisDofs } from '../../core/pose.ts';
import { DofKind, type Skeleton } from '../../core/skeleton.ts';
import { ballValue } from '../ball-values.ts';
import type { JsonValue } from '../json/decoder.ts';
import { nameIn, wordIn } from './fields.ts';
import { jointOf, nameOfSource, sourceOf } from './find.ts';
import type { TargetKind } from './motion.ts';

const words = ['tx', 'ty', 'tz', 'rx', 'ry', 'rz'] as const;
type Word = (typeof words)[number];

/** One slide or hinge of a joint: `{"joint": NAME, "value": "rx"}`. */
export const jointValue: TargetKind = {
  fields: ['joint', 'value'],
  matches: (fields) => fields.has('joint') && fields.has('value'),

  read(fields) {
    const name = nameIn(fields.get('joint')!, 'joint');
    const word = wordIn(fields.get('value')!, words);
    if (name === undefined || word === undefined) return undefined;
    return {
      names: [`${name}.${word}`],
      rotation: null,
      locate({ skeleton }, json) {
        const joint = sourceOf(skeleton, name, json.member('joint'));
        return joint === undefined ? undefined : { of: 'value', joint, ...valueOf(word) };
      },
      check({ skeleton }, json) {
        const joint = jointOf(skeleton, name, json.member('joint'));
        return joint !== undefined && hasValue(skeleton, joint, word, json.member('value'));
      },
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'value') return undefined;
    const value = words[(target.kind === DofKind.slide ? 0 : 3) + target.axis]!;
    return { joint: nameOfSource(skeleton, target.joint), value };
  },
};

function valueOf(word: Word) {
  const kind = word.startsWith('t') ? DofKind.slide : DofKind.hinge;
  return { kind, axis: 'xyz'.indexOf(word[1]!) as 0 | 1 | 2 };
}

/** Whether a joint slides or turns so, or else reports that it does not. */
function hasValue(skeleton: Skeleton, joint: number, word: Word, json: JsonValue): boolean {
  const { kind, axis } = valueOf(word);
  if (axisDofs(skeleton, joint).some((each) => each.kind === kind && each.axis === axis)) {
    return true;
  }
  const name = skeleton.names[joint]!;
  if (kind === DofKind.hinge && ballValue(skeleton, joint) >= 0) {
    json.fail('token', `"rotation" for "${name}", which turns as a ball`, word);
    return false;
  }
  const verb = kind === DofKind.slide ? 'move along' : 'turn about';
  const expected = `no ${word} for "${name}", which does not ${verb} ${word[1]!}`;
  json.warn('ignored', expected, word, 'the channel moves nothing; it is kept for saving');
  return false;
}
