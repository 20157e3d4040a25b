const smallestNormal = 2 ** -126;

/**
 * Returns the shortest decimal that reads back as the same float32. Decimals of up to six digits
 * are all distinct as normal float32 values (trailing zeros are dropped); subnormal ones may need
 * only one digit.
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

/** Returns the shortest decimal that reads back as the same double. */
export function writeFloat64(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value);
}

const encoder = new TextEncoder();

/** Encodes lines, each with a line end, as UTF-8. */
export function encodeLines(lines: readonly string[]): Uint8Array {
  return encoder.encode(lines.map((line) => `${line}\n`).join(''));
}
