import fc from 'fast-check';
import { expect, it } from 'vitest';
import { printedOnce, printJson } from '../../../src/formats/json/print-json.ts';

it('prints values whose text is kept as all others, with the sign of -0', () => {
  const { value: values } = fc.letrec<{ value: unknown }>((tie) => ({
    value: fc.oneof(
      { maxDepth: 3 },
      fc.constantFrom<unknown>(0, -0, 1e300, 'a"\n', true, null),
      fc.array(tie('value'), { maxLength: 4 }),
      fc.dictionary(fc.string({ maxLength: 2 }), tie('value'), { noNullPrototype: true }),
    ),
  }));
  fc.assert(
    fc.property(values, (value) => {
      const kept = printedOnce([value]);
      const text = printJson([value]);
      expect([printJson(kept), printJson(kept)]).toEqual([text, text]);
      expect(JSON.parse(text)).toStrictEqual([value]);
    }),
  );
});
