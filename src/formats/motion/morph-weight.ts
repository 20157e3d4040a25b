import { keyAt } from '../json/keys.ts';
import { nameIn } from './fields.ts';
import { findMorph } from './find.ts';
import type { TargetKind } from './motion.ts';

/** The weight of a morph: `{"morph": NAME}`. */
export const morphWeight: TargetKind = {
  fields: ['morph'],
  matches: (fields) => fields.has('morph'),

  read(fields) {
    const name = nameIn(fields.get('morph')!, 'morph');
    if (name === undefined) return undefined;
    return {
      names: [`morph.${name}`, name],
      rotation: null,
      find({ morphs }, json) {
        const morph = findMorph(morphs, name);
        if (typeof morph === 'number') return { of: 'morph', morph };
        json.member('morph').fail('unknown-morph', morph, name);
        return undefined;
      },
    };
  },

  write(target, { morphs }) {
    if (target.of !== 'morph' || !morphs[target.morph]) return undefined;
    const names = morphs.map(({ name }) => name);
    return { morph: keyAt(names, target.morph) };
  },
};
