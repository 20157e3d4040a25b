import type { MethodSettings } from '../skinning/method.ts';
import type { KernelRow } from '../skinning/registry.ts';
import { UsageError } from './usage-error.ts';

/**
 * The values that `--set NAME=VALUE` gives to the parameters of methods.
 *
 * @throws UsageError if none of the methods has such a parameter or it can't have the value
 */
export async function givenSettings(
  kernels: readonly KernelRow[],
  words: readonly string[],
): Promise<MethodSettings> {
  if (words.length === 0) return {};
  const loaded = await Promise.all(kernels.map(({ load }) => load()));
  const parameters = loaded.flatMap((kernel) => kernel.parameters ?? []);
  const names = parameters.map(({ name }) => name).join('|');
  return Object.fromEntries(
    words.map((word) => {
      const [name, text] = split(word);
      const parameter = parameters.find((each) => each.name === name);
      if (!parameter) {
        const known = names === '' ? 'there is nothing to set' : `there is ${names}`;
        throw new UsageError(
          `${kernels.map(({ id }) => id).join(', ')} has no "${name}"; ${known}`,
        );
      }
      const { least, most, step } = parameter;
      const value = text.trim() === '' ? NaN : Number(text);
      if (!(value >= least && value <= most)) {
        throw new UsageError(`expected --set ${name} from ${least} to ${most}, found "${text}"`);
      }
      if (step >= 1 && !Number.isInteger(value)) {
        throw new UsageError(`expected --set ${name} with a whole number, found "${text}"`);
      }
      return [name, value];
    }),
  );
}

function split(word: string): readonly [name: string, value: string] {
  const at = word.indexOf('=');
  if (at < 1) throw new UsageError(`expected --set NAME=VALUE, found "${word}"`);
  return [word.slice(0, at), word.slice(at + 1)];
}
