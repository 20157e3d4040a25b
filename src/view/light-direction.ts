import type { Light } from '../document/environment.ts';

type Angles = Pick<Light, 'azimuth' | 'elevation'>;

/** Returns the unit vector to a light, in scene space. */
export function lightDirection({ azimuth, elevation }: Angles): [number, number, number] {
  const [around, above] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const level = Math.cos(above);
  return [Math.sin(around) * level, Math.sin(above), Math.cos(around) * level];
}
