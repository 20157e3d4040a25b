import type { Editor } from '../editor.ts';
import { type Command, type ContextId, keyName, type KeyPress } from './command.ts';
import { rolledJoint } from './joint-commands.ts';
import { commands } from './registry.ts';

/** Keys that act in one state of the editor, before those of the contexts below it. */
export interface KeyContext {
  readonly id: ContextId;
  readonly label: string;
  isActive(editor: Editor): boolean;
}

/** Every context; the first match wins. Those of the timeline act where it has the focus. */
export const contexts: readonly KeyContext[] = [
  { id: 'control', label: 'With Ctrl or Cmd, in fields too', isActive: () => true },
  {
    id: 'first person',
    label: 'First person',
    isActive: ({ session }) => session.firstPerson.value,
  },
  { id: 'timeline', label: 'The timeline has the focus', isActive: () => false },
  {
    id: 'bone',
    label: 'Bone mode, on a lit or selected joint',
    isActive: ({ session }) => session.boneMode.value && rolledJoint(session) !== null,
  },
  {
    id: 'joint',
    label: 'A selected joint',
    isActive: ({ session }) => session.selectedJoint.value !== null,
  },
  {
    id: 'character',
    label: 'No joint selected',
    isActive: ({ session }) => session.selectedJoint.value === null,
  },
  { id: 'everywhere', label: '', isActive: () => true },
];

/** A key of a command. */
export interface KeyBinding {
  readonly press: KeyPress;
  readonly command: Command;
}

/** The keys of a context, one row each. */
export function keysOf(context: ContextId): readonly KeyBinding[] {
  return commands
    .filter((command) => (command.context ?? 'everywhere') === context)
    .flatMap((command) => (command.keys ?? []).map((press) => ({ press, command })));
}

/** A row of the help sheet and of docs/keys.md: the keys, and what they do. */
export type HelpRow = readonly [keys: string, does: string];

export function keyRows(context: ContextId): readonly HelpRow[] {
  return keysOf(context).map(({ press, command }) => [keyName(press), command.label]);
}

/** What the pointer does on the view. */
export const pointerRows: readonly HelpRow[] = [
  [
    'Left drag',
    'Orbit; in first person, look around; in bone mode, on a bone, turn it (Alt: roll)',
  ],
  ['Middle drag', 'Move sideways'],
  ['Right drag, wheel', 'Zoom'],
];
