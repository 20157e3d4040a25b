import { parseArgs } from 'node:util';
import type { MethodId } from '../skinning/method.ts';
import type { KernelRow } from '../skinning/registry.ts';
import { methodNamed, methodNames, methodsNamed } from './named-methods.ts';
import { joinValue, parseWords } from './parse-words.ts';
import { UsageError } from './usage-error.ts';

/** What follows FILES in the usage of a command that compares methods. */
export const comparedUsage = `[--pose POSE.json|POSE.vpd] [--methods ${methodNames.join(',')}] [--base ${methodNames.join('|')}] [--set NAME=VALUE] [--normalize] [--csv OUT.csv]`;

/** The words of a command that compares methods. */
interface ComparedOptions {
  readonly files: readonly string[];
  readonly pose: string | undefined;
  /** The base is among them. */
  readonly methods: readonly KernelRow<MethodId>[];
  readonly base: KernelRow<MethodId>;
  readonly set: readonly string[];
  readonly normalize: boolean;
  readonly csv: string | undefined;
  /** The values of the further options, by name. */
  readonly further: Readonly<Record<string, string | undefined>>;
}

/** @param names of further options, each with a value, which may be a negative number */
export function comparedOptions(
  words: readonly string[],
  names: readonly string[] = [],
): ComparedOptions {
  const args = names.reduce<readonly string[]>((all, name) => joinValue(all, `--${name}`), words);
  const { values, positionals: files } = parseWords(() =>
    parseArgs({
      args: [...args],
      options: {
        pose: { type: 'string' },
        methods: { type: 'string' },
        base: { type: 'string' },
        set: { type: 'string', multiple: true, default: [] },
        normalize: { type: 'boolean', default: false },
        csv: { type: 'string' },
        ...Object.fromEntries(names.map((name) => [name, { type: 'string' as const }])),
      },
      allowPositionals: true,
    }),
  );
  const { pose, set, normalize, csv } = values;
  if (files.length === 0) throw new UsageError('expected files, found none');
  const listed = methodsNamed('--methods', values.methods);
  const base = values.base === undefined ? listed[0]! : methodNamed('--base', values.base);
  const methods = listed.includes(base) ? listed : [base, ...listed];
  const given = values as Readonly<Record<string, unknown>>;
  const further = Object.fromEntries(
    names.map((name) => [name, given[name] as string | undefined]),
  );
  return { files, pose, methods, base, set, normalize, csv, further };
}
