import type { GUI } from 'lil-gui';
import type { SkeletonStyle } from '../../document/session.ts';
import type { Editor, ThemeChoice } from '../editor.ts';
import { watch } from '../watch.ts';
import { field, signalField } from './signal-field.ts';

/** Adds controls for what is drawn: the look of a course, or single parts. */
export function addViewFolder(gui: GUI, editor: Editor): void {
  const { session, theme, workspaces, workspaceId } = editor;
  const folder = gui.addFolder('View');
  const courses = Object.fromEntries(workspaces.map(({ label, id }) => [label, id]));
  const course = field(
    () => workspaceId.value,
    (id) => editor.setWorkspace(id),
  );
  const themes: Record<string, ThemeChoice> = { System: 'system', Light: 'light', Dark: 'dark' };
  const styles: Record<string, SkeletonStyle> = {
    Sticks: 'sticks',
    Boxes: 'boxes',
    Both: 'both',
    Lines: 'lines',
  };
  const rows = [
    folder.add(course, 'value', courses).name('Look of'),
    folder.add(signalField(session.showSkin), 'value').name('Skin'),
    folder.add(signalField(session.translucent), 'value').name('Translucent'),
    folder.add(signalField(session.showSkeleton), 'value').name('Skeleton'),
    folder.add(signalField(session.skeletonStyle), 'value', styles).name('Skeleton as'),
    folder.add(signalField(session.showAxes), 'value').name('Axes'),
    folder.add(signalField(session.showTextures), 'value').name('Textures'),
    folder.add(signalField(session.showNormals), 'value').name('Normals as lines'),
    folder.add(signalField(theme), 'value', themes).name('Colors'),
  ];
  const { showSkin, showSkeleton, skeletonStyle, showAxes, showTextures, translucent } = session;
  const flags = [showSkin, showSkeleton, skeletonStyle, showAxes, showTextures, translucent];
  watch([...flags, session.showNormals, theme, workspaceId], () => {
    for (const row of rows) row.updateDisplay();
  });
}
