import { keyAt } from '../json/keys.ts';
import { nameIn } from './fields.ts';
import { locateMorph, morphOf } from './find.ts';
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
      locate({ morphs }, json) {
        const morph = locateMorph(morphs, name, json.member('morph'));
        return morph === undefined ? undefined : { of: 'morph', morph };
      },
      check: ({ morphs }, json) => morphOf(morphs, name, json.member('morph')) !== undefined,
    };
  },

  write(target, { morphs }) {
    if (target.of !== 'morph') return undefined;
    const { morph } = target;
    const names = morphs.map(({ name }) => name);
    return { morph: morph < names.length ? keyAt(names, morph) : `#${morph}` };
  },
};
