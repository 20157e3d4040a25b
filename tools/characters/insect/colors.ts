import { abdomenRange, plates, thoraxRange } from './body.ts';
import { blend, type Color, dimples, hex, noise, ramp, shade } from './paint.ts';
import { smoothstep } from './profile.ts';

/**
 * The shell looks like polished metal; its color runs from gold-green on top to violet underneath.
 */
const shell = [hex(0x5fc24a), hex(0x12a866), hex(0x078a86), hex(0x1a5aa6), hex(0x4a2f8c)];
const copper = hex(0xd8742a);
const ember = hex(0xd2481c);
const amber = hex(0xf0992e);
const dark = hex(0x0d1620);
const night = hex(0x15203a);

/** @param across 0 on top, 1 underneath */
function metal(across: number, grain: number): Color {
  return ramp(shell, 0.08 + across * 0.85 + (grain - 0.5) * 0.22);
}

/**
 * Adds small hammered hollows with dark centers. There are none at the midlines, where they would
 * be mirrored.
 */
function pitted(color: Color, x: number, y: number, rows: number, depth: number): Color {
  const off = smoothstep(1.2, 3, Math.min(y, rows - y));
  return shade(color, 1 - depth * off * (1 - smoothstep(0.05, 0.38, dimples(x, y))));
}

export function paintAbdomen(along: number, across: number): Color {
  const z = abdomenRange[0] + along * (abdomenRange[1] - abdomenRange[0]);
  const grain = noise(along * 9, across * 4);
  let color = metal(across * 0.9 + 0.05, grain);
  const index = plates.findIndex((end) => z > end);
  if (index < 0) return blend(hex(0x2a5f86), dark, smoothstep(-0.97, -1.04, z));
  const start = index === 0 ? -0.3 : plates[index - 1]!;
  const t = (z - start) / (plates[index]! - start);
  // Each plate is blue where it emerges, gold toward its end, and has a dark hem.
  color = blend(color, hex(0x12508c), 0.75 * (1 - smoothstep(0, 0.5, t)));
  color = blend(color, hex(0xb8d13c), 0.5 * smoothstep(0.45, 0.86, t) * (1 - across));
  color = blend(
    color,
    copper,
    0.75 * smoothstep(0.72, 0.9, t) * (1 - smoothstep(0.35, 0.75, across)),
  );
  color = shade(color, 1 - 0.85 * smoothstep(0.93, 0.97, t));
  if (index === 0) color = blend(hex(0x123a5c), color, smoothstep(-0.3, -0.36, z));
  return pitted(color, along * 48, across * 16, 16, 0.2);
}

export function paintThorax(along: number, across: number): Color {
  const z = thoraxRange[0] + along * (thoraxRange[1] - thoraxRange[0]);
  let color = metal(across, noise(along * 7 + 40, across * 5));
  // There are seams between the plates of the back, and two furrows along it.
  const seam = (at: number, width: number): number => 1 - smoothstep(0, width, Math.abs(z - at));
  const furrow = 1 - smoothstep(0.012, 0.03, Math.abs(across - 0.17));
  const onBack = smoothstep(0.3, 0.26, z) * smoothstep(0.0, 0.05, z);
  color = blend(color, hex(0xc9d44a), 0.45 * smoothstep(0.2, 0, across) * onBack);
  const lines = Math.max(seam(0.335, 0.014), seam(-0.005, 0.012), 0.7 * seam(-0.06, 0.01));
  color = shade(color, 1 - 0.75 * Math.max(lines, 0.8 * furrow * onBack));
  color = blend(color, night, 0.7 * smoothstep(0.42, 0.5, z));
  return pitted(color, along * 40, across * 26, 26, 0.3);
}

export function paintHead(along: number, across: number): Color {
  let color = metal(0.1 + 0.45 * across + 0.3 * along, noise(along * 6, across * 6 + 90));
  // There are three small eyes on the crown and a bright shield above the mouth.
  for (const [at, side] of [
    [0.2, 0],
    [0.13, 0.12],
  ] as const) {
    const distance = Math.hypot(along - at, across - side);
    color = blend(hex(0x2a0d08), color, smoothstep(0.025, 0.04, distance));
  }
  color = blend(
    color,
    hex(0x9bd13e),
    0.55 * smoothstep(0.3, 0.05, across) * smoothstep(0.45, 0.7, along),
  );
  color = blend(color, night, 0.8 * smoothstep(0.86, 0.97, along));
  return pitted(color, along * 24, across * 24, 24, 0.26);
}

export function paintEye(along: number, across: number): Color {
  const color = ramp([hex(0x7a1f12), hex(0x4a0f14), hex(0x1c0a12)], 0.15 + across * 1.1);
  const cell = dimples(along * 44, across * 22);
  const glow = Math.exp(-(((along - 0.34) / 0.16) ** 2) - ((across - 0.3) / 0.22) ** 2);
  return blend(shade(color, 1.05 - 0.3 * cell), hex(0xd06a3a), 0.45 * glow);
}

/**
 * Coxa and tibia have the colors of the shell, the femur that of embers, and the joints are dark.
 */
export function paintLeg(along: number, across: number): Color {
  const place = along * 3.25;
  const grain = noise(along * 30, across * 3);
  const shin = ramp([hex(0x17707e), hex(0x14366a), hex(0x191a44)], across + 0.3 * (grain - 0.5));
  const thigh = ramp([amber, ember, hex(0x8a2412)], 0.1 + across * 0.95 + 0.2 * (grain - 0.5));
  const hip = metal(0.35 + 0.6 * across, grain);
  let color = blend(hip, thigh, smoothstep(1.02, 1.07, place));
  color = blend(color, shin, smoothstep(1.84, 1.93, place));
  const joint = Math.max(
    1 - smoothstep(0.015, 0.05, Math.abs(place - 1.01)),
    1 - smoothstep(0.03, 0.07, Math.abs(place - 2)),
    smoothstep(2.93, 3, place),
  );
  return blend(color, dark, 0.85 * joint);
}

/** Paints one bead of a foot. */
export function paintTarsus(along: number, across: number): Color {
  const color = ramp([hex(0xc8742c), hex(0x7a3a18), hex(0x3a1a12)], across * 0.8 + 0.1);
  const edge = Math.max(1 - smoothstep(0, 0.16, along), smoothstep(0.86, 1, along));
  return blend(color, dark, 0.9 * edge);
}

/** Paints one bead of an antenna. */
export function paintAntenna(along: number, across: number): Color {
  const color = ramp([hex(0x2b3550), hex(0x171c30), hex(0x0c0f1c)], across);
  return blend(
    color,
    hex(0x70401c),
    0.8 * smoothstep(0.7, 0.85, along) * smoothstep(1, 0.93, along),
  );
}

export function paintMandible(along: number, across: number): Color {
  const color = ramp([hex(0xd98a34), hex(0x9a4518), hex(0x4a1c10)], across * 0.7 + 0.3 * along);
  return blend(color, dark, 0.92 * smoothstep(0.55, 0.8, along));
}
