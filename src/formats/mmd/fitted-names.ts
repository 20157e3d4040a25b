import { fittedText } from './encode-name.ts';

/**
 * Returns names as fields of `size` bytes can hold them, in the same order. Names that were
 * different stay different: of two names that are equal as far as the field holds them, the second becomes
 * "a long name of a (2)". Names that were equal stay equal.
 */
export function fittedNames(names: readonly string[], size: number): string[] {
  const fitted = names.map((name) => fittedText(name, size));
  const originalOf = new Map<string, string>();
  // Names that fit as they are keep their text, wherever they stand.
  names.forEach((name, index) => {
    if (fitted[index] === name) originalOf.set(name, name);
  });
  const fieldOf = new Map<string, string>();
  const lastNumber = new Map<string, number>();
  return names.map((name, index) => {
    const known = fieldOf.get(name);
    if (known !== undefined) return known;
    const wanted = fitted[index]!;
    let number = lastNumber.get(wanted) ?? 1;
    let unique = wanted;
    while ((originalOf.get(unique) ?? name) !== name) {
      const ending = ` (${++number})`;
      unique = fittedText(wanted, size - ending.length) + ending;
    }
    lastNumber.set(wanted, number);
    originalOf.set(unique, name);
    fieldOf.set(name, unique);
    return unique;
  });
}
