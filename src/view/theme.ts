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
    backdropTop: linear('#c9d2dd'),
    backdropBottom: linear('#efece6'),
    floorLight: linear('#ece9e2'),
    floorDark: linear('#dbd8d1'),
    shadowStrength: 1,
  },
  dark: {
    backdropTop: linear('#17191d'),
    backdropBottom: linear('#2b2d31'),
    floorLight: linear('#34363a'),
    floorDark: linear('#2b2d31'),
    shadowStrength: 1.2,
  },
};

export const palette = {
  clay: linear('#a5a29c'),
  bone: linear('#e4dccb'),
  boneLine: linear('#2f5d8c'),
  litBone: linear('#d9480f'),
  hovered: linear('#fff6d6'),
  selected: linear('#ffab2e'),
  axes: [linear('#e5484d'), linear('#46a758'), linear('#3b82f6')],
} as const;
