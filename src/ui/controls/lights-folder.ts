import type { GUI } from 'lil-gui';
import { type Light, studioLights } from '../../document/session.ts';
import type { Looking } from '../editor.ts';
import { watch } from '../watch.ts';

/** Adds controls for the color, strength and direction of each light. */
export function addLightsFolder(gui: GUI, { session: { lights } }: Looking): void {
  const folder = gui.addFolder('Lights').close();
  const rows = lights.value.flatMap((light, index) => {
    const one = folder.addFolder(light.name).close();
    const change = <K extends keyof Light>(key: K): Record<K, Light[K]> =>
      Object.defineProperty({} as Record<K, Light[K]>, key, {
        get: () => lights.value[index]![key],
        set: (value: Light[K]) => {
          lights.value = lights.value.map((old, i) =>
            i === index ? { ...old, [key]: value } : old,
          );
        },
      });
    return [
      one.addColor(change('color'), 'color').name('Color'),
      one.add(change('intensity'), 'intensity', 0, 3).name('Strength').decimals(2),
      one.add(change('azimuth'), 'azimuth', -180, 180).name('Around °').decimals(0),
      one.add(change('elevation'), 'elevation', -89, 89).name('Above °').decimals(0),
    ];
  });
  folder.add({ reset: () => (lights.value = studioLights) }, 'reset').name('Reset lights');
  watch([lights], () => {
    for (const row of rows) row.updateDisplay();
  });
}
