import type { GUI } from 'lil-gui';
import type { SkeletonStyle } from '../../document/session.ts';
import type { Editor, ThemeChoice } from '../editor.ts';
import { addCommandRow } from './command-row.ts';
import { field, signalField } from './signal-field.ts';
import { watch } from '../watch.ts';

const degreesPerRadian = 180 / Math.PI;

/** Adds controls for what is drawn, and for the camera. */
export function addViewFolder(gui: GUI, editor: Editor): void {
  const { session, viewer, theme } = editor;
  const { camera } = viewer;
  const folder = gui.addFolder('View');
  const angle = (key: 'azimuth' | 'elevation') =>
    field(
      () => camera.value[key] * degreesPerRadian,
      (degrees: number) => (camera.value = { ...camera.value, [key]: degrees / degreesPerRadian }),
    );
  const distance = field(
    () => camera.value.distance,
    (value: number) => (camera.value = { ...camera.value, distance: value }),
  );
  const themes: Record<string, ThemeChoice> = { System: 'system', Light: 'light', Dark: 'dark' };
  const styles: Record<string, SkeletonStyle> = {
    Sticks: 'sticks',
    Boxes: 'boxes',
    Both: 'both',
    Lines: 'lines',
  };
  const rows = [
    folder.add(signalField(session.showSkin), 'value').name('Skin'),
    folder.add(signalField(session.translucent), 'value').name('Translucent'),
    folder.add(signalField(session.showSkeleton), 'value').name('Skeleton'),
    folder.add(signalField(session.skeletonStyle), 'value', styles).name('Skeleton as'),
    folder.add(signalField(session.showAxes), 'value').name('Axes'),
    folder.add(signalField(session.showTextures), 'value').name('Textures'),
    folder.add(signalField(theme), 'value', themes).name('Colors'),
    folder.add(angle('azimuth'), 'value', -180, 180).name('Azimuth °').decimals(1),
    folder.add(angle('elevation'), 'value', -89, 89).name('Elevation °').decimals(1),
    folder.add(distance, 'value', 0.02, 10).name('Distance').decimals(2),
  ];
  addCommandRow(folder, editor, 'frame');
  addCommandRow(folder, editor, 'reset-camera');
  const { showSkin, showSkeleton, skeletonStyle, showAxes, showTextures, translucent } = session;
  const flags = [showSkin, showSkeleton, skeletonStyle, showAxes, showTextures, translucent];
  watch([...flags, theme, camera], () => {
    for (const row of rows) row.updateDisplay();
  });
}
