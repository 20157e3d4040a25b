import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import { type Command, type ContextId, keyName, type KeyPress } from './command.ts';
import { rolledJoint } from './joint-commands.ts';
import { commands } from './registry.ts';

/** A group of keys that act in one state of the editor; they take precedence over later groups. */
export interface KeyContext {
  readonly id: ContextId;
  readonly label: string;
  isActive(editor: Editor): boolean;
}

/**
 * Every context; the first match wins. The timeline handles its own keys while it has the focus.
 */
export const contexts: readonly KeyContext[] = [
  { id: 'control', label: 'With Ctrl or Cmd, also in text fields', isActive: () => true },
  { id: 'clipboard', label: 'With Ctrl or Cmd, outside of text', isActive: () => true },
  {
    id: 'first person',
    label: 'With the first-person camera',
    isActive: ({ session }) => session.firstPerson.value,
  },
  { id: 'timeline', label: 'While the timeline has the focus', isActive: () => false },
  {
    id: 'turning',
    label: 'While a joint is selected, also in the list of joints',
    isActive: ({ session }) => session.selectedJoint.value !== null,
  },
  {
    id: 'placing',
    label: 'While the character is moved, turned or scaled as a whole',
    isActive: (editor) => isPlacing(editor),
  },
  {
    id: 'chain',
    label: 'With inverse kinematics, while a joint is selected or a chain is dragged',
    isActive: ({ session }) => {
      const { ikMode, selectedJoint, shownChain } = session;
      const isDragged = (shownChain.value?.target ?? null) !== null;
      return isDragged || (ikMode.value && selectedJoint.value !== null);
    },
  },
  {
    id: 'bone',
    label: 'In bone mode, with a highlighted or selected joint',
    isActive: ({ session }) => session.boneMode.value && rolledJoint(session) !== null,
  },
  {
    id: 'joint',
    label: 'While a joint is selected',
    isActive: ({ session }) => session.selectedJoint.value !== null,
  },
  {
    id: 'character',
    label: 'While no joint is selected',
    isActive: ({ session }) => session.selectedJoint.value === null,
  },
  { id: 'everywhere', label: '', isActive: () => true },
];

/** Whether a tool for whole characters has one to act on. */
function isPlacing({ store, session }: Editor): boolean {
  const { placeTool, selectedJoint } = session;
  const isChosen = placeTool.value !== null && selectedJoint.value === null;
  return isChosen && selectedActor(store, session) !== undefined;
}

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

/** A row of the help sheet and of docs/keys.md: the keys and their effect. */
export type HelpRow = readonly [keys: string, does: string];

export function keyRows(context: ContextId): readonly HelpRow[] {
  return keysOf(context).map(({ press, command }) => [keyName(press), command.label]);
}

/** The actions of the pointer on the view. */
export const pointerRows: readonly HelpRow[] = [
  ['Click', 'Select the limb, or deselect it beside all limbs'],
  ['Shift+click', 'Select one more limb, or one less'],
  [
    'Left drag on the selected limb',
    'Turn it (Alt: roll it); in bone mode, any limb; in the Mannequin workspace, in bone mode alone',
  ],
  [
    'Left drag on the selected limb, with inverse kinematics or Shift',
    'Move its whole chain (wheel: more or fewer joints in the chain)',
  ],
  [
    'Left drag on an arrow, a square or the ring of the selected joint',
    'Move the target of its chain, or a root (Shift: a tenth; Ctrl/Cmd: in steps of 0.05)',
  ],
  [
    'Left drag on a ring',
    'Turn the selected joints by one angle, about the line of sight by the outer ring (Shift: a tenth; Ctrl/Cmd: in steps of 15°)',
  ],
  [
    'Left drag on an arrow, a square or a ring of the whole character',
    'Move, turn or scale it (Shift: a tenth; Ctrl/Cmd: in steps of 0.1 or 15°); while it is moved, the character is a handle too',
  ],
  [
    'Left drag on the diamond of a pin',
    'Move its place, and the joint with it; a click selects it',
  ],
  [
    'Left drag on the square of a target of the file, with inverse kinematics',
    'Move the end of its chain',
  ],
  ['Double-click on a name', 'Rename the character'],
  [
    'Left drag on a light, while they have handles',
    'Move it around the characters (Ctrl/Cmd: in steps of 15°)',
  ],
  ['Left drag elsewhere', 'Orbit; with the first-person camera, look around'],
  ['Middle drag', 'Pan'],
  ['Right drag, wheel', 'Zoom'],
];
