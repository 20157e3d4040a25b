/** A color as lightness, and distances from gray toward red and toward yellow. */
export type Lab = readonly [lightness: number, red: number, yellow: number];

/** CIELAB of an sRGB color whose channels are from 0 to 255, for the white point D65. */
export function labOf(rgb: readonly [number, number, number]): Lab {
  const [r, g, b] = rgb.map((byte) => {
    const value = byte / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  }) as [number, number, number];
  const x = (0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047;
  const y = 0.2126729 * r + 0.7151522 * g + 0.072175 * b;
  const z = (0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883;
  const [fx, fy, fz] = [x, y, z].map((part) =>
    part > (6 / 29) ** 3 ? Math.cbrt(part) : part / (3 * (6 / 29) ** 2) + 4 / 29,
  ) as [number, number, number];
  return [116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)];
}

const degrees = Math.PI / 180;

/**
 * How far apart two colors look: CIEDE2000, after Sharma, Wu and Dalal, “The CIEDE2000
 * color-difference formula” (2005), with all weights 1.
 */
export function colorDifference(first: Lab, second: Lab): number {
  const [l1, a1, b1] = first;
  const [l2, a2, b2] = second;
  const seventh = (chroma: number): number => Math.sqrt(chroma ** 7 / (chroma ** 7 + 25 ** 7));
  const stretch = 1.5 - 0.5 * seventh((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2);
  const chroma1 = Math.hypot(stretch * a1, b1);
  const chroma2 = Math.hypot(stretch * a2, b2);
  const hue = (a: number, b: number): number =>
    a === 0 && b === 0 ? 0 : (Math.atan2(b, stretch * a) / degrees + 360) % 360;
  const [hue1, hue2] = [hue(a1, b1), hue(a2, b2)];
  const isGray = chroma1 * chroma2 === 0;
  const turn = ((hue2 - hue1 + 540) % 360) - 180; // the short way around
  const hueDifference = 2 * Math.sqrt(chroma1 * chroma2) * Math.sin((turn / 2) * degrees);
  const meanHue = isGray ? hue1 + hue2 : (hue1 + turn / 2 + 360) % 360;
  const lightness = (l1 + l2) / 2;
  const chroma = (chroma1 + chroma2) / 2;

  const cosine = (factor: number, offset: number): number =>
    Math.cos((factor * meanHue + offset) * degrees);
  const t =
    1 - 0.17 * cosine(1, -30) + 0.24 * cosine(2, 0) + 0.32 * cosine(3, 6) - 0.2 * cosine(4, -63);
  const scaleL = 1 + (0.015 * (lightness - 50) ** 2) / Math.sqrt(20 + (lightness - 50) ** 2);
  const scaleC = 1 + 0.045 * chroma;
  const scaleH = 1 + 0.015 * chroma * t;
  const blue = 60 * degrees * Math.exp(-(((meanHue - 275) / 25) ** 2));
  const rotation = -2 * seventh(chroma) * Math.sin(blue);
  const partL = (l2 - l1) / scaleL;
  const partC = (chroma2 - chroma1) / scaleC;
  const partH = hueDifference / scaleH;
  return Math.sqrt(partL ** 2 + partC ** 2 + partH ** 2 + rotation * partC * partH);
}
