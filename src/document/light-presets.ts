import { sameValue } from '../core/same-value.ts';
import { type Background, type Environment, type Light, studio } from './environment.ts';

/** A whole environment to begin from. */
export interface LightPreset {
  readonly id: string;
  readonly label: string;
  readonly environment: Environment;
}

/** A light without its name: color, intensity, azimuth, elevation. */
type LightRow = readonly [color: string, intensity: number, azimuth: number, elevation: number];

/** Returns a key, a fill and a rim light. */
function lights(...rows: readonly [LightRow, LightRow, LightRow]): Light[] {
  return rows.map(([color, intensity, azimuth, elevation], index) => ({
    ...{ name: studio.lights[index]!.name, color, intensity, azimuth, elevation },
  }));
}

function gradient(color: string, topColor: string): Background {
  return { kind: 'gradient', color, topColor };
}

/** Every preset, the start first. To add one, add a row. */
export const lightPresets: readonly LightPreset[] = [
  { id: 'studio', label: 'Studio', environment: studio },
  {
    id: 'soft',
    label: 'Soft',
    environment: {
      ...studio,
      lights: lights(
        ['#fffaf3', 0.8, -24, 58],
        ['#eef4ff', 0.4, 62, 24],
        ['#ffffff', 0.25, 180, 45],
      ),
      ambient: { color: '#fffdf8', intensity: 1.5 },
      shadow: { kind: 'mapped', darkness: 0.1 },
      floor: { kind: 'plain', reflection: 0 },
    },
  },
  {
    id: 'side',
    label: 'Side light',
    environment: {
      lights: lights(
        ['#ffe9d2', 1.75, -84, 26],
        ['#b9ccff', 0.08, 96, 10],
        ['#dfe9ff', 0.4, 140, 30],
      ),
      ambient: { color: '#dfe6f5', intensity: 0.4 },
      shadow: { kind: 'mapped', darkness: 0.4 },
      floor: { kind: 'plain', reflection: 0.2 },
      background: gradient('#4b5058', '#1f2227'),
    },
  },
  {
    id: 'back',
    label: 'Back light',
    environment: {
      lights: lights(
        ['#fff3e0', 2.1, 160, 38],
        ['#e3edff', 0.5, 10, 24],
        ['#ffe6c4', 0.9, -140, 24],
      ),
      ambient: { color: '#e8eefb', intensity: 0.7 },
      shadow: { kind: 'mapped', darkness: 0.38 },
      floor: { kind: 'plain', reflection: 0.6 },
      background: gradient('#8a96a3', '#3a434d'),
    },
  },
  {
    id: 'noon',
    label: 'Noon',
    environment: {
      ...studio,
      lights: lights(['#fffaf0', 1.7, -30, 72], ['#d6e6ff', 0.18, 90, 20], ['#ffffff', 0, 168, 34]),
      ambient: { color: '#eaf3ff', intensity: 0.95 },
      shadow: { kind: 'planar', darkness: 0.45 },
    },
  },
  {
    id: 'low-sun',
    label: 'Low sun',
    environment: {
      lights: lights(
        ['#ffb46b', 1.9, -28, 12],
        ['#9db8ff', 0.3, 100, 24],
        ['#ffc890', 0.7, 172, 20],
      ),
      ambient: { color: '#cfd6ff', intensity: 0.75 },
      shadow: { kind: 'mapped', darkness: 0.34 },
      floor: { kind: 'plain', reflection: 0 },
      background: gradient('#e6b592', '#7288b4'),
    },
  },
  {
    id: 'night',
    label: 'Night',
    environment: {
      lights: lights(
        ['#b4c8ff', 0.95, -54, 52],
        ['#6f8cff', 0.12, 96, 12],
        ['#c6d6ff', 1.1, 150, 26],
      ),
      ambient: { color: '#93a8ff', intensity: 0.35 },
      shadow: { kind: 'mapped', darkness: 0.5 },
      floor: { kind: 'plain', reflection: 0.5 },
      background: gradient('#222c40', '#0a0e17'),
    },
  },
];

/** The preset that an environment is as a whole, if any. */
export function presetOf(environment: Environment): LightPreset | undefined {
  return lightPresets.find((preset) => sameValue(preset.environment, environment));
}
