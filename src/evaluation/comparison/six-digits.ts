/** Six digits of a number, which is what float32 positions give. */
export function sixDigits(value: number | null): number | null {
  return value === null ? null : Number(value.toPrecision(6));
}
