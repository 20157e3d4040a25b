/** Reads what an earlier visit kept under a key; empty where the browser keeps nothing. */
export function keptValue(key: string): string {
  try {
    return localStorage.getItem(`sinew ${key}`) ?? '';
  } catch {
    return '';
  }
}

/** Keeps a value for the next visit, where the browser lets it. */
export function keepValue(key: string, value: string): void {
  try {
    localStorage.setItem(`sinew ${key}`, value);
  } catch {
    // The value holds for this visit alone.
  }
}
