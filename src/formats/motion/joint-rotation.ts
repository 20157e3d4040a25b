import { rotationTrack } from '../../core/motion/rotation-track.ts';
import type { RotationTarget } from '../../core/motion/clip-parts.ts';
import { keyAt } from '../json/keys.ts';
import { nameIn, wordIn } from './fields.ts';
import { jointOf } from './find.ts';
import type { TargetKind } from './motion.ts';

/** The whole rotation of a joint: `{"joint": NAME, "rotation": "squad"}`. */
export const jointRotation: TargetKind = {
  fields: ['joint', 'rotation'],
  matches: (fields) => fields.has('joint') && fields.has('rotation'),

  read(fields) {
    const name = nameIn(fields.get('joint')!, 'joint');
    const rotation = wordIn(fields.get('rotation')!, ['slerp', 'squad']);
    if (name === undefined || rotation === undefined) return undefined;
    return {
      names: [`${name}.rotation`, `${name}.${rotation}`, name],
      rotation,
      find({ skeleton }, json) {
        const joint = jointOf(skeleton, name, json);
        if (joint === undefined) return undefined;
        const source = skeleton.sourceIndex[joint]!;
        const target: RotationTarget = { of: 'rotation', joint: source, curve: rotation };
        const parts = { target, before: 'constant', after: 'constant', keys: [] } as const;
        if (rotationTrack(parts, skeleton)) return target;
        const expected = `no rotation for "${skeleton.names[joint]!}", which does not turn about every axis`;
        const effect = 'the channel moves nothing; it is kept for saving';
        json.member('rotation').warn('ignored', expected, rotation, effect);
        return undefined;
      },
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'rotation') return undefined;
    const joint = skeleton.jointOfSource[target.joint];
    if (joint === undefined) return undefined;
    return { joint: keyAt(skeleton.names, joint, target.joint), rotation: target.curve };
  },
};
