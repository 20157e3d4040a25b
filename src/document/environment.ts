import type { Edit } from './edit.ts';

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

/** What surrounds the actors of a scene. */
export interface Environment {
  /** The key, fill and rim lights. */
  readonly lights: readonly Light[];
}

/** A warm key light from the upper left, a cool fill light, and a rim light from behind. */
export const studioLights: readonly Light[] = [
  { name: 'Key', color: '#fff7ec', intensity: 1.45, azimuth: -18, elevation: 48 },
  { name: 'Fill', color: '#d9eaff', intensity: 0.22, azimuth: 88, elevation: 16 },
  { name: 'Rim', color: '#eef7ff', intensity: 0.5, azimuth: 168, elevation: 34 },
];

/** The studio in which every scene begins. */
export const studio: Environment = { lights: studioLights };

/** Changes some of what surrounds the actors. */
export function setEnvironment(change: Partial<Environment>, label: string): Edit {
  return {
    label,
    apply: (scene) => ({ ...scene, environment: { ...scene.environment, ...change } }),
  };
}

/** Changes some of one light. */
export function setLight(index: number, change: Partial<Light>, label: string): Edit {
  return {
    label,
    apply(scene) {
      const lights = scene.environment.lights.map((light, i) =>
        i === index ? { ...light, ...change } : light,
      );
      return { ...scene, environment: { ...scene.environment, lights } };
    },
  };
}
