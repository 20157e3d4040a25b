import { pinValues } from '../../core/motion/targets.ts';
import { nameIn, wordIn } from './fields.ts';
import { jointOf, nameOfSource, sourceOf } from './find.ts';
import type { TargetKind } from './motion.ts';

/** A coordinate of a pin, or its weight: `{"pin": NAME, "value": "x"}`. */
export const pinValue: TargetKind = {
  fields: ['pin', 'value'],
  matches: (fields) => fields.has('pin'),

  read(fields) {
    const name = nameIn(fields.get('pin')!, 'joint');
    const json = fields.get('value');
    if (!json) fields.get('pin')!.fail('json', `"value" with one of ${pinValues.join(', ')}`);
    const value = json && wordIn(json, pinValues);
    if (name === undefined || value === undefined) return undefined;
    return {
      names: [`pin.${name}.${value}`, `${name}.${value}`],
      rotation: null,
      locate({ skeleton }, target) {
        const joint = sourceOf(skeleton, name, target.member('pin'));
        return joint === undefined ? undefined : { of: 'pin', joint, value };
      },
      check: ({ skeleton }, target) => jointOf(skeleton, name, target.member('pin')) !== undefined,
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'pin') return undefined;
    return { pin: nameOfSource(skeleton, target.joint), value: target.value };
  },
};
