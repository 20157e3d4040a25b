/** The shortest decimal that reads back as the same float32. */
export function writeFloat32(value: number): string {
  if (Object.is(value, -0)) return '-0';
  for (let precision = 6; precision < 9; precision++) {
    const short = Number(value.toPrecision(precision));
    if (Math.fround(short) === value) return String(short);
  }
  return String(Number(value.toPrecision(9)));
}

/** The shortest decimal that reads back as the same double. */
export function writeFloat64(value: number): string {
  return Object.is(value, -0) ? '-0' : String(value);
}

const encoder = new TextEncoder();

/** Lines, each ended, as UTF-8. */
export function encodeLines(lines: readonly string[]): Uint8Array {
  return encoder.encode(lines.map((line) => `${line}\n`).join(''));
}
