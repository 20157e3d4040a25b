import { pinValues } from '../../core/motion/targets.ts';
import { keyAt } from '../json/keys.ts';
import { nameIn, wordIn } from './fields.ts';
import { findJoint } from '../pose-json.ts';
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
      find({ skeleton }, target) {
        const joint = findJoint(skeleton, name);
        if (typeof joint === 'number') {
          return { of: 'pin', joint: skeleton.sourceIndex[joint]!, value };
        }
        target.member('pin').fail('unknown-joint', joint, name);
        return undefined;
      },
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'pin') return undefined;
    const joint = skeleton.jointOfSource[target.joint];
    if (joint === undefined) return undefined;
    return { pin: keyAt(skeleton.names, joint, target.joint), value: target.value };
  },
};
