import type { Material } from './mit-text.ts';

/**
 * The figure resembles a sculptor's mannequin: adult, lean and androgynous. MakeHuman's base mesh
 * is a neutral start for its targets and not meant to be shown, so this mixes MakeHuman's own macro
 * targets. They only move vertices, so they add no bytes to the file.
 */

/** 0 is female, 1 is male. */
const GENDER = 0.75;

/** The weight of MakeHuman's target for classical proportions. */
const IDEAL_PROPORTIONS = 0.5;

/** From average muscles (0) to strong ones (1). */
const MUSCLE = 0.15;

/** The peoples of three continents are mixed in equal parts. */
const PEOPLES = ['african', 'asian', 'caucasian'];

/** These targets give a plain chest, and a calm face instead of the mix's stern one. */
const RETOUCH: readonly (readonly [target: string, weight: number])[] = [
  ['breast/nipple-point-decr', 0.25],
  ['mouth/mouth-angles-up', 0.55],
  ['eyebrows/eyebrows-angle-up', 0.35],
  ['head/head-oval', 0.3],
];

/** Returns target names under `targets/`, without the file extension, and the weight of each. */
export function shapeTargets(): ReadonlyMap<string, number> {
  const targets = new Map<string, number>();
  for (const [gender, share] of [
    ['female', 1 - GENDER],
    ['male', GENDER],
  ] as const) {
    const body = `macrodetails/universal-${gender}-young`;
    targets.set(`${body}-averagemuscle-averageweight`, share * (1 - MUSCLE));
    targets.set(`${body}-maxmuscle-averageweight`, share * MUSCLE);
    for (const people of PEOPLES) {
      targets.set(`macrodetails/${people}-${gender}-young`, share / PEOPLES.length);
    }
    const proportions = `macrodetails/proportions/${gender}-young-averagemuscle-averageweight`;
    targets.set(`${proportions}-idealproportions`, share * IDEAL_PROPORTIONS);
  }
  const chest = 'breast/female-young-averagemuscle-averageweight-mincup-averagefirmness';
  targets.set(chest, 1 - GENDER);
  for (const [target, weight] of RETOUCH) targets.set(target, weight);
  return targets;
}

/** The colors of its materials, in tone with clay; the skin has none and is clay itself. */
export const MATERIALS: readonly Material[] = [
  { name: 'skin' },
  { name: 'lips', color: [0.78, 0.62, 0.55] },
  { name: 'brows', color: [0.52, 0.4, 0.33] },
  { name: 'eyes', color: [0.88, 0.84, 0.8], gloss: [0.25, 60] },
  { name: 'iris rims', color: [0.25, 0.21, 0.18], gloss: [0.4, 120] },
  { name: 'irises', color: [0.42, 0.34, 0.27], gloss: [0.4, 120] },
  { name: 'pupils', color: [0.05, 0.05, 0.05], gloss: [0.4, 120] },
  { name: 'teeth', color: [0.88, 0.87, 0.83] },
  { name: 'tongue', color: [0.66, 0.5, 0.46] },
];
