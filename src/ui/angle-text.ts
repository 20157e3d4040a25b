const degreesPerRadian = 180 / Math.PI;

export function formatDegrees(radians: number): string {
  const degrees = Math.round(radians * degreesPerRadian * 10) / 10;
  return `${degrees === 0 ? 0 : degrees}°`;
}

/**
 * Parses a typed number: radians (or a length) without a unit, degrees with ° or deg; NaN if it is
 * neither.
 */
export function parseTyped(text: string): number {
  const match = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*(°|deg)?\s*$/i.exec(text);
  if (!match) return NaN;
  const value = Number(match[1]);
  return match[2] === undefined ? value : value / degreesPerRadian;
}
