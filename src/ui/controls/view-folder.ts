import type { Signal } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import type { Editor } from '../editor.ts';
import { watch } from '../watch.ts';

/** What is drawn, and from where. */
export function addViewFolder(gui: GUI, editor: Editor): void {
  const { session, viewer } = editor;
  const folder = gui.addFolder('View');
  const rows = [
    folder.add(flag(session.showSkin), 'value').name('Skin'),
    folder.add(flag(session.showSkeleton), 'value').name('Skeleton'),
    folder.add(flag(session.showAxes), 'value').name('Axes'),
  ];
  const { camera } = viewer;
  const angle = (key: 'azimuth' | 'elevation') => ({
    get value(): number {
      return (camera.value[key] * 180) / Math.PI;
    },
    set value(degrees: number) {
      camera.value = { ...camera.value, [key]: (degrees * Math.PI) / 180 };
    },
  });
  const distance = {
    get value(): number {
      return camera.value.distance;
    },
    set value(value: number) {
      camera.value = { ...camera.value, distance: value };
    },
  };
  rows.push(
    folder.add(angle('azimuth'), 'value', -180, 180).name('Azimuth °').decimals(1),
    folder.add(angle('elevation'), 'value', -89, 89).name('Elevation °').decimals(1),
    folder.add(distance, 'value', 0.02, 10).name('Distance').decimals(2),
  );
  const actions = {
    frame: () => viewer.frameAll(),
    reset: () => editor.setWorkspace(editor.workspaceId.value),
  };
  folder.add(actions, 'frame').name('Frame (Home)');
  folder.add(actions, 'reset').name('Reset camera (Space)');
  watch([session.showSkin, session.showSkeleton, session.showAxes, camera], () => {
    for (const row of rows) row.updateDisplay();
  });
}

function flag(signal: Signal<boolean>): { value: boolean } {
  return {
    get value() {
      return signal.value;
    },
    set value(value: boolean) {
      signal.value = value;
    },
  };
}
