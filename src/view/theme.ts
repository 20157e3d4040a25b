export type ThemeName = 'light' | 'dark';

/** The colors of the scene, in linear light. */
export interface Theme {
  readonly backdropTop: readonly number[];
  readonly backdropBottom: readonly number[];
  readonly floorLight: readonly number[];
  readonly floorDark: readonly number[];
  readonly shadowStrength: number;
}

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
  axes: [linear('#e5484d'), linear('#46a758'), linear('#3b82f6')],
} as const;
