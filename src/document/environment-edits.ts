import type { Edit } from './edit.ts';
import type { Environment, Light } from './environment.ts';

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
