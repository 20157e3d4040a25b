import type { GUI } from 'lil-gui';
import { type AxisViewId, axisViewOf, axisViews } from '../../view/axis-views.ts';
import { fieldOfViewOf, focalLengthOf } from '../../view/camera-moves.ts';
import { runCommand } from '../commands/command.ts';
import { commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';
import { addCommandRow } from './command-row.ts';
import { field } from './signal-field.ts';

const degreesPerRadian = 180 / Math.PI;

/** The choices of the row for axis views; a view along no axis is free. */
const directions: Readonly<Record<string, AxisViewId | 'free'>> = {
  Free: 'free',
  ...Object.fromEntries(axisViews.map(({ label, id }) => [label, id])),
};

/** Adds the camera's place, angles and lens. */
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
  const focalLength = field(
    () => focalLengthOf(camera.value.fieldOfView),
    (value: number) => (camera.value = { ...camera.value, fieldOfView: fieldOfViewOf(value) }),
  );
  const direction = field<AxisViewId | 'free'>(
    () => axisViewOf(camera.value)?.id ?? 'free',
    (id) => id !== 'free' && runCommand(commandOf(`view-${id}`), editor),
  );
  const place = [
    folder.add(distance, 'value', 0.02, 10).name('Distance').decimals(2),
    folder.add(angle('azimuth'), 'value', -180, 180).name('Azimuth °').decimals(1),
    folder.add(angle('elevation'), 'value', -90, 90).name('Elevation °').decimals(1),
  ];
  const lens = folder.add(focalLength, 'value', 12, 200).decimals(1);
  const from = folder.add(direction, 'value', directions).name('From');
  addCommandRow(folder, editor, 'orthographic');
  addCommandRow(folder, editor, 'frame');
  addCommandRow(folder, editor, 'reset-camera');
  addCommandRow(folder, editor, 'first-person');
  watch([camera], () => {
    const { projection, fieldOfView } = camera.value;
    for (const row of [...place, lens, from]) row.updateDisplay();
    // Without perspective the lens does the same as the distance.
    lens.show(projection === 'perspective');
    lens.name(`Lens mm (${(fieldOfView * degreesPerRadian).toFixed(1)}°)`);
  });
}
