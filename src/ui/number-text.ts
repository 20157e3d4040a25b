/** Three decimals; what rounds to nothing has no sign. */
export function fixedText(value: number): string {
  const text = value.toFixed(3);
  return text === '-0.000' ? '0.000' : text;
}
