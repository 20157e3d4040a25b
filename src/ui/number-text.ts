/** Formats a number with three decimals; a value that rounds to zero has no sign. */
export function fixedText(value: number): string {
  const text = value.toFixed(3);
  return text === '-0.000' ? '0.000' : text;
}

/** Formats a length with three digits, and without zeros at its end. */
export function formatSize(length: number): string {
  return String(Number(length.toPrecision(3)));
}
