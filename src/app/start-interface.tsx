// This import makes components follow the signals that they read.
import '@preact/signals';
import { effect } from '@preact/signals-core';
import { render } from 'preact';
import { holdEdits } from '../evaluation/hold-edits.ts';
import { settlePins } from '../evaluation/settle-pins.ts';
import { listenToClipboard } from '../ui/clipboard.ts';
import { followCursor } from '../ui/cursor.ts';
import { listenToDrops } from '../ui/drop-zone.ts';
import { listenToKeys } from '../ui/keys.ts';
import { followChains } from '../ui/lit-chain.ts';
import { nameView } from '../ui/name-view.ts';
import { keepOneTool } from '../ui/one-tool.ts';
import { Dialogs } from '../ui/panels/dialogs.tsx';
import { PhoneBar } from '../ui/panels/phone-bar.tsx';
import { Sections } from '../ui/panels/sections.tsx';
import { TopBar } from '../ui/panels/top-bar.tsx';
import { ViewOverlay } from '../ui/panels/view-overlay.tsx';
import { listenToPointer } from '../ui/pointer.ts';
import { followComparison } from '../ui/deform-lab/follow-comparison.ts';
import { followShots } from '../ui/shots.ts';
import { addSheetHandle } from '../ui/sheet-handle.ts';
import { addSplitter } from '../ui/splitter.ts';
import { createPace } from '../view/frame-pace.ts';
import { passes } from '../view/passes/registry.ts';
import type { CatalogueScene } from './catalogue.ts';
import { createEditor } from './create-editor.ts';
import type { OpeningOfScenes } from './create-opening.ts';
import type { Layout } from './layout.ts';
export { loadWasmKernel } from './load-wasm-kernel.ts';
import { runClock } from './run-clock.ts';
import { followLinks } from './scenes/follow-links.ts';
import { createScripting, type Scripting } from './scripting.ts';

/**
 * Starts panels, keys, pointer and scripting. They are loaded after the first picture, which does
 * not need them.
 */
export function startInterface(
  layout: Layout,
  opening: OpeningOfScenes,
  ready: Promise<void>,
  { drafts, scenes }: { readonly drafts: boolean; readonly scenes: readonly CatalogueScene[] },
): Scripting {
  opening.viewer.passes.value = passes;
  opening.store.settle = (scene) => settlePins(scene, opening.evaluations);
  holdEdits(opening.store, opening.session, opening.evaluations);
  if (drafts) opening.viewer.pace = createPace(opening.session);
  const editor = createEditor(opening, layout.canvas, scenes);
  render(<TopBar editor={editor} />, layout.top);
  render(<Sections editor={editor} place="left" />, layout.left);
  render(<Sections editor={editor} place="right" />, layout.right);
  render(<PhoneBar editor={editor} />, layout.phone);
  render(<ViewOverlay editor={editor} />, layout.overlay);
  render(<Sections editor={editor} place="foot" />, layout.foot);
  render(<Dialogs editor={editor} />, layout.dialogs);
  addSplitter(layout, 'left');
  addSplitter(layout, 'right');
  addSheetHandle(layout.root, editor);
  listenToKeys(editor);
  listenToDrops(opening, layout.canvas);
  listenToClipboard(editor);
  followLinks(opening.parts);
  runClock(editor.session, editor.transport);
  listenToPointer(layout.canvas, editor);
  nameView(layout.canvas, editor);
  followCursor(layout.canvas, editor);
  followChains(editor);
  followShots(editor);
  followComparison(editor);
  keepOneTool(editor.session);
  effect(() => {
    layout.root.dataset['drawer'] = editor.drawer.value ?? '';
  });
  return createScripting(editor, ready);
}
