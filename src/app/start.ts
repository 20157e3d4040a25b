import { type Signal, signal } from '@preact/signals-core';
import { Failure, loadPart } from '../core/failure.ts';
import { reconcile } from '../document/reconcile.ts';
import { Session } from '../document/session.ts';
import { Store } from '../document/store.ts';
import { Evaluations } from '../evaluation/evaluations.ts';
import { Kernels } from '../evaluation/kernels.ts';
import { failureText } from '../ui/attempt.ts';
import { guardDrops } from '../ui/guard-drops.ts';
import { refinement } from '../view/refinement.ts';
import { Viewer } from '../view/viewer.ts';
import {
  type Catalogue,
  type CatalogueEntry,
  type CatalogueScene,
  fetchCatalogue,
} from './catalogue.ts';
import { createOpening, type OpeningOfScenes } from './create-opening.ts';
import { createLayout } from './layout.ts';
import { hasLink, mayRestore } from './scenes/at-start.ts';
import type { Scripting } from './scripting.ts';
import { followTheme } from './theme.ts';
import { workspaces } from './workspaces.ts';

declare global {
  interface Window {
    /** Has only `ready` until that has settled. */
    sinew: Scripting;
  }
}

/** Assembles the app; this is the only place that knows all of its parts. */
export async function start(root: HTMLElement): Promise<void> {
  let settleReady = (): void => undefined;
  const ready = new Promise<void>((resolve) => (settleReady = resolve));
  window.sinew = { ready } as Scripting;
  const parameters = new URLSearchParams(location.search);
  const isTest = parameters.has('test');
  if (isTest) document.documentElement.dataset['test'] = '';
  const listed = fetchCatalogue();
  const layout = createLayout(root);
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const onFailed = (error: unknown): void => void (opening.notice.value = failureText(error));
  const kernels = new Kernels({
    complete: async () =>
      (await loadPart(import('./kernel-parts.ts'))).preparationsInWorkers(onFailed),
    onFailed,
  });
  const evaluations = new Evaluations(store, session, kernels);
  const catalogue = signal<readonly CatalogueEntry[]>([]);
  let firstFrameShown = (): void => undefined;
  const firstFrame = new Promise<void>((resolve) => (firstFrameShown = resolve));
  const viewer = new Viewer(layout.canvas, store, session, evaluations, () => {
    if (store.scene.value.actors.length === 0) return;
    if (performance.getEntriesByName('first-frame').length > 0) return;
    performance.mark('first-frame');
    firstFrameShown();
  });
  const opening = createOpening(store, session, evaluations, viewer, catalogue);
  layout.follow(viewer, isTest ? 1 : undefined);
  followTheme(opening.theme, viewer);
  guardDrops();

  // An empty picture would only keep the first character waiting.
  viewer.waiting.value = true;
  const opened = openNamed(opening, catalogue, listed, parameters, firstFrame);
  // Creating a context keeps the page busy for a while, so the character is requested first.
  await listed.catch(() => undefined); // the failure is reported by what opens
  const textures = (parameters.get('textures') ?? '').split(',');
  viewer.connect({
    paletteTexture: textures.includes('palette'),
    influenceTexture: textures.includes('influences'),
  });
  await opened;
  viewer.waiting.value = false;
  viewer.drawNow();
  // Without a character or a context there is no first picture to wait for; the rest of the page
  // works all the same.
  if (store.scene.value.actors.length === 0 || !viewer.available.value) firstFrameShown();
  await firstFrame;
  const refined = refinement.load();
  const { loadWasmKernel, startInterface } = await loadPart(import('./start-interface.tsx'));
  await refined;
  const { scenes } = await listed.catch(() => ({ scenes: [] }));
  window.sinew = startInterface(layout, opening, ready, { drafts: !isTest, scenes });
  settleReady();
  await loadWasmKernel(kernels);
}

/**
 * Opens what the page's address names; without names, the scene that was kept, or else the first
 * one. An unknown name gives a message, and the first entry is opened.
 */
async function openNamed(
  opening: OpeningOfScenes,
  catalogue: Signal<readonly CatalogueEntry[]>,
  listed: Promise<Catalogue>,
  parameters: URLSearchParams,
  firstFrame: Promise<void>,
): Promise<void> {
  const notes: string[] = [];
  const named = <T extends { readonly id: string }>(list: readonly T[], key: string) => {
    const wanted = parameters.get(key);
    const found = list.find(({ id }) => id === wanted);
    if (wanted !== null && !found) notes.push(`There is no ${key} "${wanted}"`);
    return found ?? list[0];
  };
  opening.setWorkspace(named(workspaces, 'workspace')!.id);
  let scene: CatalogueScene | undefined;
  try {
    const { characters, scenes } = await listed;
    catalogue.value = characters;
    scene = scenes[0];
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    notes.push(error.message);
  }
  const isNamed = parameters.has('model') || parameters.has('workspace');
  let isOpened = false;
  if (hasLink() || mayRestore()) {
    const { openAtStart } = await loadPart(import('./scenes/open-at-start.ts'));
    const { opened, message } = await openAtStart(opening.parts, isNamed);
    if (message !== '') notes.push(message);
    isOpened = opened;
  }
  if (!isOpened && scene && !isNamed) {
    await opening.openScene(scene, firstFrame).first;
  } else if (!isOpened) {
    const character = named(catalogue.value, 'model');
    if (character) await opening.openBundled(character.id);
  }
  if (notes.length > 0) opening.notice.value = notes.join('; ');
}
