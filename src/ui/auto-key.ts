import { keyByThemselves } from '../evaluation/auto-key.ts';
import type { Editor } from './editor.ts';

const ready = new WeakSet<Editor['store']>();

/** Lets edits key themselves, or ends that. */
export function toggleAutoKey({ store, session, evaluations, notice }: Editor): void {
  if (!ready.has(store)) keyByThemselves(store, session, evaluations);
  ready.add(store);
  const isOn = !session.autoKey.value;
  session.autoKey.value = isOn;
  notice.value = isOn ? 'Auto-key: every edit is keyed when it ends' : 'Auto-key is off';
}
