import type { JsonValue } from '../../formats/json/decoder.ts';
import { kernels } from '../../skinning/registry.ts';
import {
  type ComparedMethod,
  type Comparison,
  comparisonLayouts,
  comparisonOf,
  mostMethods,
} from '../comparison.ts';
import { checked, type Codec, flag, index, listOf, numberWithin, oneOf } from './codec.ts';
import { type Codecs, readFields, writeFields } from './fields.ts';

const ids = kernels.map(({ id }) => id);
const plain = comparisonOf(['own', 'linear-blend']);

const rows: Codecs<Comparison> = {
  methods: checked(
    listOf<ComparedMethod>(oneOf(['own', ...ids]), mostMethods),
    (methods) => methods.length >= 2 && new Set(methods).size === methods.length,
    `from 2 to ${mostMethods} different methods`,
  ),
  layout: oneOf(comparisonLayouts),
  wipes: checked(
    listOf(numberWithin(0, 1), mostMethods - 1),
    (wipes) => wipes.every((wipe, i) => wipe >= (wipes[i - 1] ?? 0)),
    'increasing numbers',
  ),
  base: index,
  heatMap: flag,
  normalizeRows: flag,
};

/** How methods are compared in the view. */
export const comparisonJson: Codec<Comparison> = {
  write: (value) => writeFields(rows, value),
  read(json) {
    const read = readFields(rows, json);
    if (!read?.methods) return undefined;
    const found = { ...plain, ...comparisonOf(read.methods), ...read };
    const isWhole = found.wipes.length === found.methods.length - 1;
    return {
      ...found,
      ...(!isWhole && { wipes: comparisonOf(read.methods).wipes }),
      base: Math.min(found.base, found.methods.length - 1),
    };
  },
};

/** What earlier versions of Sinew wrote in its place: the kernel beside each actor's own, or null. */
export const formerComparison = {
  name: 'comparedKernel',
  read(json: JsonValue): { readonly comparison: Comparison } | undefined {
    const id = ids.find((each) => each === json.member(formerComparison.name).value);
    return id && { comparison: { ...comparisonOf(['own', id]), layout: 'side by side' } };
  },
};
