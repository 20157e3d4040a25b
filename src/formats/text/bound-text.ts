/** Formats a bound for messages, such as "3.4e38". */
export function boundText(value: number): string {
  return Number(value.toPrecision(2)).toExponential().replace('+', '');
}
