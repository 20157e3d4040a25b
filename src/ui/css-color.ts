/** A color of three bytes (sRGB) as CSS writes it. */
export function cssColor(bytes: ArrayLike<number>): string {
  return `rgb(${bytes[0]!} ${bytes[1]!} ${bytes[2]!})`;
}
