import { loadPart } from '../core/failure.ts';
import {
  type GhostSettings,
  type MotionView,
  motionViewOf,
  type TrailSettings,
} from '../document/motion-view.ts';
import type { Session } from '../document/session.ts';
import type { Looking, Telling } from './editor.ts';
import { showTrailKeys } from './trail-keys-shown.ts';

type Part = 'ghosts' | 'trails';

/** The parts that draw are loaded once for each page, when they are first asked for. */
const loading: Readonly<Record<Part, WeakMap<Session, Promise<void>>>> = {
  ghosts: new WeakMap(),
  trails: new WeakMap(),
};

/** Changes how ghosts are shown. Resolves when what draws them is there. */
export async function changeGhosts(editor: Looking, change: Partial<GhostSettings>): Promise<void> {
  const { ghosts } = viewOf(editor);
  ghosts.value = { ...ghosts.value, ...change };
  if (ghosts.value.isOn) await loadOnce(editor, 'ghosts', () => loadGhosts(editor));
}

/** Changes how trails are shown. Resolves when what draws them is there. */
export async function changeTrails(
  editor: Looking & Telling,
  change: Partial<TrailSettings>,
): Promise<void> {
  const { trails } = viewOf(editor);
  trails.value = { ...trails.value, ...change };
  if (trails.value.isOn) await loadOnce(editor, 'trails', () => loadTrails(editor));
}

function viewOf({ session }: Looking): MotionView {
  return motionViewOf(session);
}

async function loadGhosts({ viewer, store, session }: Looking): Promise<void> {
  const { showGhosts } = await loadPart(import('../view/ghosts.ts'));
  showGhosts(viewer, store, session);
}

async function loadTrails(editor: Looking & Telling): Promise<void> {
  const { createTrailKeys } = await loadPart(import('./trail-keys.ts'));
  showTrailKeys(editor.session, createTrailKeys(editor));
}

function loadOnce({ session }: Looking, part: Part, load: () => Promise<void>): Promise<void> {
  const begun = loading[part].get(session) ?? load();
  loading[part].set(session, begun);
  // What failed is tried again with the next change.
  begun.catch(() => loading[part].delete(session));
  return begun;
}
