import type { Environment } from '../document/environment.ts';

export type ThemeName = 'light' | 'dark';

/** The colors of the scene, in linear light. */
export interface Theme {
  readonly backdropTop: readonly number[];
  readonly backdropBottom: readonly number[];
  readonly floorLight: readonly number[];
  readonly floorDark: readonly number[];
  readonly shadowStrength: number;
}

/** A dark check of a floor of the user's own color, as a part of a light one. */
const darkCheck = 0.88;

/** Converts the display's #rrggbb to linear light. */
export function linear(hex: string): number[] {
  return [1, 3, 5].map((at) => linearChannel(parseInt(hex.slice(at, at + 2), 16) / 255));
}

/** Converts a channel from the display's encoding (sRGB, 0 to 1) to linear light. */
export function linearChannel(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}

export const themes: Readonly<Record<ThemeName, Theme>> = {
  light: {
    backdropTop: linear('#b9c6d4'),
    backdropBottom: linear('#e3eaf1'),
    floorLight: linear('#dbe4ed'),
    floorDark: linear('#cfd9e4'),
    shadowStrength: 1,
  },
  dark: {
    backdropTop: linear('#13171d'),
    backdropBottom: linear('#242b34'),
    floorLight: linear('#2d3641'),
    floorDark: linear('#262e38'),
    shadowStrength: 1.2,
  },
};

/**
 * The theme's colors, or those of the scene's own background, to which the floor then belongs. A
 * plain floor has one color.
 */
export function themeIn({ background, floor }: Environment, theme: Theme): Theme {
  const { kind, color, topColor } = background;
  const own = linear(color);
  const colors =
    kind === 'color' || kind === 'gradient'
      ? {
          backdropTop: kind === 'color' ? own : linear(topColor),
          backdropBottom: own,
          floorLight: own,
          floorDark: own.map((channel) => channel * darkCheck),
          shadowStrength: 1,
        }
      : theme;
  return floor.kind === 'plain' ? { ...colors, floorDark: colors.floorLight } : colors;
}

/** The studio's clays as the display's #rrggbb, warm to dark; a look has the index of one. */
export const clayColors = [
  '#b3998a',
  '#a5a29c',
  '#b17761',
  '#94a08a',
  '#8798ab',
  '#9d8aa3',
  '#75665b',
  '#55565c',
] as const;

export const palette = {
  /** The linear light of `clayColors`. */
  clays: clayColors.map(linear),
  bone: linear('#e4dccb'),
  boneLine: linear('#2f5d8c'),
  litBone: linear('#d9480f'),
  hovered: linear('#fff6d6'),
  selected: linear('#ffab2e'),
  /** The ring about the line of sight. */
  screenRing: linear('#8e9aa8'),
  axes: [linear('#e5484d'), linear('#46a758'), linear('#3b82f6')],
} as const;
