import { effect, signal } from '@preact/signals-core';
import { Session } from '../document/session.ts';
import { Store } from '../document/store.ts';
import { listenToDrops } from '../ui/drop-zone.ts';
import { listenToKeys } from '../ui/keys.ts';
import { listenToPaste } from '../ui/paste.ts';
import { listenToPointer } from '../ui/pointer.ts';
import { orbitTool } from '../ui/tools/orbit.ts';
import { Viewer } from '../view/viewer.ts';
import { type CatalogueEntry, fetchCatalogue } from './catalogue.ts';
import { createEditor } from './create-editor.ts';
import { createLayout } from './layout.ts';
import { FileOpener } from './open-files.ts';
import { createScripting, type Scripting } from './scripting.ts';
import { followTheme } from './theme.ts';
import { workspaces } from './workspaces.ts';

declare global {
  interface Window {
    sinew: Scripting;
  }
}

/** Puts the app together: the one place that knows all of its parts. */
export async function start(root: HTMLElement): Promise<void> {
  const parameters = new URLSearchParams(location.search);
  const isTest = parameters.has('test');
  if (isTest) document.documentElement.dataset['test'] = '';
  const layout = createLayout(root);
  const store = new Store();
  const session = new Session();
  const catalogue = signal<readonly CatalogueEntry[]>([]);
  let firstFrameShown = (): void => undefined;
  const firstFrame = new Promise<void>((resolve) => (firstFrameShown = resolve));
  const textures = (parameters.get('textures') ?? '').split(',');
  const skinLayout = {
    paletteTexture: textures.includes('palette'),
    influenceTexture: textures.includes('influences'),
  };
  const viewer = new Viewer(layout.canvas, store, session, skinLayout, () => {
    if (store.document.value.characters.length === 0) return;
    if (performance.getEntriesByName('first-frame').length > 0) return;
    performance.mark('first-frame');
    firstFrameShown();
  });
  const editor = createEditor(store, session, viewer, new FileOpener(store, session), catalogue);
  window.sinew = createScripting(editor, firstFrame);
  layout.follow(viewer, isTest ? 1 : undefined);
  followTheme(editor.theme, viewer);
  effect(() => {
    root.dataset['drawer'] = editor.drawer.value ?? '';
  });
  listenToKeys(editor);
  listenToDrops(editor);
  listenToPaste(editor);
  listenToPointer(layout.canvas, orbitTool, editor);

  const wanted = workspaces.find(({ id }) => id === parameters.get('workspace'));
  editor.setWorkspace((wanted ?? workspaces[0]!).id);
  catalogue.value = await fetchCatalogue();
  await editor.openBundled(parameters.get('model') ?? catalogue.value[0]!.id);
  // Without a context there is no picture to wait for; the rest is as alive.
  if (!viewer.available.value) firstFrameShown();
  if (store.document.value.characters.length > 0) await firstFrame;
  const { mountPanels } = await import('./mount-panels.tsx');
  mountPanels(layout, editor);
}
