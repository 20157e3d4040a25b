import { blend, type Color, hex, noise, ramp } from './paint.ts';
import { smoothstep } from './profile.ts';

/** A point of the wing: along from its root (0 to 1), across from its leading edge (0 to 1). */
type Spot = readonly [along: number, across: number];

/** The veins from the root outward, and those between them. */
const veins: readonly (readonly Spot[])[] = [
  [
    [0, 0.3],
    [0.2, 0.1],
    [0.5, 0.055],
    [0.72, 0.02],
  ],
  [
    [0, 0.4],
    [0.18, 0.3],
    [0.38, 0.25],
    [0.62, 0.2],
    [0.84, 0.08],
  ],
  [
    [0.18, 0.3],
    [0.34, 0.42],
    [0.6, 0.44],
    [0.83, 0.42],
    [0.97, 0.4],
  ],
  [
    [0, 0.52],
    [0.2, 0.56],
    [0.42, 0.64],
    [0.66, 0.68],
    [0.92, 0.74],
  ],
  [
    [0.06, 0.62],
    [0.24, 0.78],
    [0.45, 0.88],
    [0.62, 0.98],
  ],
  [
    [0.42, 0.64],
    [0.52, 0.8],
    [0.6, 0.98],
  ],
  [
    [0.34, 0.27],
    [0.36, 0.42],
  ],
  [
    [0.5, 0.22],
    [0.52, 0.44],
  ],
  [
    [0.66, 0.18],
    [0.69, 0.43],
  ],
  [
    [0.31, 0.4],
    [0.33, 0.6],
  ],
  [
    [0.54, 0.44],
    [0.56, 0.66],
  ],
  [
    [0.74, 0.43],
    [0.76, 0.7],
  ],
  [
    [0.22, 0.57],
    [0.26, 0.79],
  ],
];

/**
 * The wing's length divided by its breadth, which makes veins as thick along the wing as across it.
 */
const aspect = 2.6;

function distanceToVein(spots: readonly Spot[], along: number, across: number): number {
  let nearest = Infinity;
  for (let index = 0; index + 1 < spots.length; index++) {
    const [[ax, ay], [bx, by]] = [spots[index]!, spots[index + 1]!];
    const [dx, dy] = [(bx - ax) * aspect, by - ay];
    const [px, py] = [(along - ax) * aspect, across - ay];
    const t = Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy)));
    nearest = Math.min(nearest, Math.hypot(px - t * dx, py - t * dy));
  }
  return nearest;
}

const film = [hex(0xe8b65c), hex(0xdca24c), hex(0xc98a44), hex(0x9a6436), hex(0x6a4428)];
const vein = hex(0x2c1810);

/**
 * An amber film that darkens toward the tip, with an iridescent sheen, dark veins and a dark mark
 * at the edge.
 */
export function paintWing(along: number, across: number): Color {
  // A slight waver keeps the veins from looking straight.
  const x = along + 0.006 * (noise(along * 14, across * 9) - 0.5);
  const y = across + 0.02 * (noise(along * 11 + 50, across * 7) - 0.5);
  let color = ramp(film, 0.08 + 0.75 * along * along + 0.16 * across);
  const sheen = noise(along * 6 + 9, across * 4);
  color = blend(color, hex(0x8cc8a0), 0.22 * smoothstep(0.55, 0.85, sheen));
  color = blend(color, hex(0xd88a9a), 0.2 * smoothstep(0.45, 0.15, sheen));
  let strength = 0;
  veins.forEach((spots, index) => {
    const half = index < 6 ? 0.017 - 0.008 * along : 0.009;
    const distance = distanceToVein(spots, x, y);
    strength = Math.max(strength, 1 - smoothstep(half * 0.5, half * 1.4, distance));
  });
  const mark = Math.hypot((along - 0.7) * 9, (across - 0.04) * 15);
  strength = Math.max(strength, 0.9 * smoothstep(1, 0.7, mark));
  strength = Math.max(strength, smoothstep(0.035, 0.005, across), smoothstep(0.985, 1, across));
  strength = Math.max(strength, 0.8 * smoothstep(0.06, 0, along));
  return blend(color, vein, 0.92 * strength);
}
