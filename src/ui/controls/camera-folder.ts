import type { GUI } from 'lil-gui';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { field } from './signal-field.ts';

const degreesPerRadian = 180 / Math.PI;

/** Adds the camera's distance and angles. */
export function addCameraFolder(gui: GUI, editor: Editor): void {
  const { camera } = editor.viewer;
  const folder = gui.addFolder('Camera');
  const angle = (key: 'azimuth' | 'elevation') =>
    field(
      () => camera.value[key] * degreesPerRadian,
      (degrees: number) => (camera.value = { ...camera.value, [key]: degrees / degreesPerRadian }),
    );
  const distance = field(
    () => camera.value.distance,
    (value: number) => (camera.value = { ...camera.value, distance: value }),
  );
  const rows = [
    folder.add(distance, 'value', 0.02, 10).name('Distance').decimals(2),
    folder.add(angle('azimuth'), 'value', -180, 180).name('Azimuth °').decimals(1),
    folder.add(angle('elevation'), 'value', -89, 89).name('Elevation °').decimals(1),
  ];
  addCommandRow(folder, editor, 'frame');
  addCommandRow(folder, editor, 'reset-camera');
  addCommandRow(folder, editor, 'first-person');
  watch([camera], () => {
    for (const row of rows) row.updateDisplay();
  });
}
