import { rotationTrack } from '../../core/motion/rotation-track.ts';
import { nameIn, wordIn } from './fields.ts';
import { jointOf, nameOfSource, sourceOf } from './find.ts';
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
      locate({ skeleton }, json) {
        const joint = sourceOf(skeleton, name, json.member('joint'));
        return joint === undefined ? undefined : { of: 'rotation', joint, curve: rotation };
      },
      check({ skeleton }, json) {
        const joint = jointOf(skeleton, name, json.member('joint'));
        if (joint === undefined) return false;
        const source = skeleton.sourceIndex[joint]!;
        const target = { of: 'rotation', joint: source, curve: rotation } as const;
        const parts = { target, before: 'constant', after: 'constant', keys: [] } as const;
        if (rotationTrack(parts, skeleton)) return true;
        const expected = `no rotation for "${skeleton.names[joint]!}", which does not turn about every axis`;
        const effect = 'the channel moves nothing; it is kept for saving';
        json.member('rotation').warn('ignored', expected, rotation, effect);
        return false;
      },
    };
  },

  write(target, { skeleton }) {
    if (target.of !== 'rotation') return undefined;
    return { joint: nameOfSource(skeleton, target.joint), rotation: target.curve };
  },
};
