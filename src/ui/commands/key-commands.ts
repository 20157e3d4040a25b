import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

/** Commands that set keys, which are loaded when they are first used. */
export const keyCommands = [
  {
    id: 'set-key',
    label: 'Set a key of what is unkeyed, else of the selected joints, else of the whole pose',
    short: 'Set a key',
    keys: [{ key: 'k' }],
    isEnabled: hasCharacter,
    run: setKey,
  },
  {
    id: 'set-key-here',
    label: 'Set a key',
    keys: [{ key: 'k' }],
    keyOnly: true,
    context: 'timeline',
    isEnabled: hasCharacter,
    run: setKey,
  },
  {
    id: 'auto-key',
    label: 'Auto-key: every edit is keyed when it ends',
    short: 'Auto-key',
    isOn: ({ session }) => session.autoKey.value,
    run: async (editor) => (await loadPart(import('../auto-key.ts'))).toggleAutoKey(editor),
  },
] as const satisfies readonly Command[];

function hasCharacter({ store, session }: Editor): boolean {
  return selectedActor(store, session) !== undefined;
}

async function setKey(editor: Editor): Promise<void> {
  (await loadPart(import('../set-key.ts'))).setKeyHere(editor);
}
