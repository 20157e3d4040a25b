/**
 * Colors by how they look: lightness from 0 to 1, chroma from 0 (gray), hue in degrees. After
 * Ottosson, “A perceptual color space for image processing” (2020), https://bottosson.github.io/posts/oklab.
 */
export interface Lch {
  readonly lightness: number;
  readonly chroma: number;
  readonly hue: number;
}

/** The red, green and blue of a color. */
export type Triple = readonly [number, number, number];

/** The linear light of a color, which may be outside of what a display shows (0 to 1). */
export function linearOf({ lightness, chroma, hue }: Lch): Triple {
  const angle = (hue * Math.PI) / 180;
  const [a, b] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

/** The same color with as much of its chroma as a display shows; 12 halvings find 1/4000 of it. */
export function displayable(color: Lch): Lch {
  if (isDisplayable(color)) return color;
  let [least, most] = [0, color.chroma];
  for (let halving = 0; halving < 12; halving++) {
    const chroma = (least + most) / 2;
    if (isDisplayable({ ...color, chroma })) least = chroma;
    else most = chroma;
  }
  return { ...color, chroma: least };
}

function isDisplayable(color: Lch): boolean {
  return linearOf(color).every((channel) => channel >= -1e-4 && channel <= 1 + 1e-4);
}

/** The bytes of a color for the display (sRGB), which it must be able to show. */
export function bytesOf(color: Lch): Triple {
  const [r, g, b] = linearOf(color).map((channel) => Math.round(255 * encodedChannel(channel)));
  return [r!, g!, b!];
}

/** A channel of linear light, encoded for the display (sRGB, 0 to 1). */
export function encodedChannel(light: number): number {
  const within = Math.min(1, Math.max(0, light));
  return within <= 0.0031308 ? 12.92 * within : 1.055 * within ** (1 / 2.4) - 0.055;
}
