import { signal } from '@preact/signals-core';
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
import { FileOpener } from './open-files.ts';
import { createLayout } from './layout.ts';
import { createScripting, type Scripting } from './scripting.ts';
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
  const gl = layout.canvas.getContext('webgl2', { antialias: false, alpha: false, depth: false });
  if (!gl) {
    layout.showMessage(
      'Sinew draws with WebGL2, which this browser does not offer here. Turn on hardware ' +
        'acceleration in its settings, or try a current Chrome, Edge, Firefox or Safari.',
    );
    return;
  }

  const store = new Store();
  const session = new Session();
  const catalogue = signal<readonly CatalogueEntry[]>([]);
  let firstFrameShown: () => void;
  const firstFrame = new Promise<void>((resolve) => (firstFrameShown = resolve));
  const viewer = new Viewer(layout.canvas, gl, store, session, () => {
    if (store.document.value.characters.length === 0) return;
    if (performance.getEntriesByName('first-frame').length > 0) return;
    performance.mark('first-frame');
    firstFrameShown();
  });
  const editor = createEditor(store, session, viewer, new FileOpener(store, session), catalogue);
  window.sinew = createScripting(editor, firstFrame);
  layout.follow(viewer, isTest ? 1 : undefined);
  listenToKeys(editor);
  listenToDrops(editor);
  listenToPaste(editor);
  listenToPointer(layout.canvas, orbitTool, editor);
  followTheme(viewer);

  const wanted = workspaces.find(({ id }) => id === parameters.get('workspace'));
  editor.setWorkspace((wanted ?? workspaces[0]!).id);
  catalogue.value = await fetchCatalogue();
  await editor.openBundled(parameters.get('model') ?? catalogue.value[0]!.id);
  if (!isTest) {
    await firstFrame;
    const { mountPanels } = await import('./mount-panels.tsx');
    mountPanels(layout, editor);
  }
}

/** Light or dark as the system has it. */
function followTheme(viewer: Viewer): void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const set = (): void => {
    viewer.theme.value = dark.matches ? 'dark' : 'light';
  };
  dark.addEventListener('change', set);
  set();
}
