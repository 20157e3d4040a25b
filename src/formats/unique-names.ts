const longestName = 256;

/**
 * Returns unique names for display and for poses, in the same order: the file's names, cut if they
 * are too long, with "knee (2)" for the second of a name and "joint 03" for a missing name.
 */
export function uniqueNames(fileNames: readonly string[], kind = 'joint'): string[] {
  const digits = Math.max(2, String(fileNames.length - 1).length);
  const wanted = fileNames.map(
    (name, index) => cut(name) || `${kind} ${String(index).padStart(digits, '0')}`,
  );
  const taken = new Set(wanted);
  const seen = new Set<string>();
  const lastNumber = new Map<string, number>();
  return wanted.map((name) => {
    if (!seen.has(name)) {
      seen.add(name);
      return name;
    }
    let number = lastNumber.get(name) ?? 1;
    let unique: string;
    do unique = `${name} (${++number})`;
    while (taken.has(unique));
    lastNumber.set(name, number);
    taken.add(unique);
    seen.add(unique);
    return unique;
  });
}

function cut(name: string): string {
  return Array.from(name.slice(0, longestName * 2))
    .slice(0, longestName)
    .join('');
}
