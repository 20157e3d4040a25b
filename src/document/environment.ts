/** A distant light; the first one casts shadows. */
export interface Light {
  readonly name: string;
  /** #rrggbb, in the display's encoding. */
  readonly color: string;
  readonly intensity: number;
  /** Degrees about +y, from +z (where characters look) toward +x (their left). */
  readonly azimuth: number;
  /** Degrees above the floor. */
  readonly elevation: number;
}

/** Light from all around, brighter from above than from the floor. */
export type Ambient = Pick<Light, 'color' | 'intensity'>;

/**
 * What the key light's shadow is: mapped, so that it also falls on the characters; planar, which is
 * sharp and falls on the floor alone; or off.
 */
export type ShadowKind = 'mapped' | 'planar' | 'off';

export interface Shadow {
  readonly kind: ShadowKind;
  /** The part of the floor's light that the shadow takes, 0 to 1. */
  readonly darkness: number;
}

export type FloorKind = 'checks' | 'plain' | 'off';

export interface Floor {
  readonly kind: FloorKind;
  /** How strongly the floor mirrors what stands on it, 0 to 1. */
  readonly reflection: number;
}

export type BackgroundKind = 'theme' | 'color' | 'gradient' | 'transparent';

export interface Background {
  readonly kind: BackgroundKind;
  /** #rrggbb: the color, or the lower one of a gradient. */
  readonly color: string;
  /** #rrggbb: the upper color of a gradient. */
  readonly topColor: string;
}

/** What surrounds the actors of a scene. */
export interface Environment {
  /** The key, fill and rim lights. */
  readonly lights: readonly Light[];
  readonly ambient: Ambient;
  readonly shadow: Shadow;
  readonly floor: Floor;
  readonly background: Background;
}

/**
 * The studio in which every scene begins: a warm key light from the upper left, a cool fill light,
 * and a rim light from behind.
 */
export const studio: Environment = {
  lights: [
    { name: 'Key', color: '#fff7ec', intensity: 1.45, azimuth: -18, elevation: 48 },
    { name: 'Fill', color: '#d9eaff', intensity: 0.22, azimuth: 88, elevation: 16 },
    { name: 'Rim', color: '#eef7ff', intensity: 0.5, azimuth: 168, elevation: 34 },
  ],
  ambient: { color: '#ffffff', intensity: 1 },
  shadow: { kind: 'mapped', darkness: 0.22 },
  floor: { kind: 'checks', reflection: 0 },
  background: { kind: 'theme', color: '#c9d3dd', topColor: '#8fa3b8' },
};
