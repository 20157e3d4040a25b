const smallestNormal = 2 ** -126;

/**
 * The shortest decimal that reads back as the same float32. Six digits tell all normal ones of so
 * few digits apart (trailing zeros go); subnormal ones may need as little as one.
 */
export function writeFloat32(value: number): string {
  if (Object.is(value, -0)) return '-0';
  const fewest = Math.abs(value) < smallestNormal ? 1 : 6;
  for (let precision = fewest; precision < 9; precision++) {
    const short = Number(value.toPrecision(precision));
    if (Math.fround(short) === value) return String(short);
  }
  return String(Number(value.toPrecision(9)));
}

/** The shortest decimal that reads back as the same double. */
export function writeFloat64(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value);
}

/** A bound as messages show it: "3.4e38". */
export function boundText(value: number): string {
  return Number(value.toPrecision(2)).toExponential().replace('+', '');
}

const encoder = new TextEncoder();

/** Lines, each ended, as UTF-8. */
export function encodeLines(lines: readonly string[]): Uint8Array {
  return encoder.encode(lines.map((line) => `${line}\n`).join(''));
}
