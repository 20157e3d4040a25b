import { setLook } from '../../document/look-edits.ts';
import { setFitted, setTransform } from '../../document/place-edits.ts';
import { type Actor, unmoved } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { PlaceTool } from '../../document/session.ts';
import { lowestPoint } from '../../evaluation/lowest-point.ts';
import type { Editor } from '../editor.ts';
import { nudge } from '../nudge.ts';
import type { Command } from './command.ts';

const hasActor = (editor: Editor): boolean => selectedOf(editor) !== undefined;

/** Commands for the place, the size and the name of the whole selected character. */
export const placeCommands = [
  {
    id: 'look-tool',
    label: 'Look around, and pose the limb that is clicked',
    short: 'Look',
    isOn: ({ session }) => !session.boneMode.value && session.placeTool.value === null,
    run: ({ session }) => {
      session.boneMode.value = false;
      session.placeTool.value = null;
    },
  },
  {
    id: 'move-tool',
    label: 'Move the character',
    short: 'Move',
    keys: [{ key: 'w' }],
    context: 'character',
    isOn: ({ session }) => session.placeTool.value === 'move',
    isEnabled: hasActor,
    run: (editor) => chooseTool(editor, 'move'),
  },
  {
    id: 'turn-tool',
    label: 'Turn the character',
    short: 'Turn',
    keys: [{ key: 'e', shift: false }],
    context: 'character',
    isOn: ({ session }) => session.placeTool.value === 'turn',
    isEnabled: hasActor,
    run: (editor) => chooseTool(editor, 'turn'),
  },
  {
    id: 'scale-tool',
    label: 'Scale the character',
    short: 'Scale',
    keys: [{ key: 'e', shift: true }],
    context: 'character',
    isOn: ({ session }) => session.placeTool.value === 'scale',
    isEnabled: hasActor,
    run: (editor) => chooseTool(editor, 'scale'),
  },
  {
    id: 'place-axes',
    label: "Move and turn along the character's own axes, or the scene's",
    short: 'Own axes',
    keys: [{ key: 'q' }],
    context: 'placing',
    isOn: ({ session }) => session.placeAxes.value === 'local',
    run: ({ session }) => {
      session.placeAxes.value = session.placeAxes.value === 'local' ? 'world' : 'local';
    },
  },
  {
    id: 'set-on-floor',
    label: 'Set the character on the floor',
    short: 'Set on the floor',
    isEnabled: hasActor,
    run: setOnFloor,
  },
  {
    id: 'fit',
    label: 'Fit the character to one unit, or show it in its own units',
    short: 'Fit to 1 unit',
    isOn: (editor) => selectedOf(editor)?.fitted ?? true,
    isEnabled: hasActor,
    run: toggleFitted,
  },
  {
    id: 'reset-place',
    label: 'Move the character back to the origin, upright and in its first size',
    short: 'Reset the place',
    isEnabled: hasActor,
    run: (editor) => {
      const actor = selectedOf(editor);
      if (!actor) return;
      editor.store.dispatch(setTransform(actor.id, unmoved, `Reset the place of ${actor.name}`));
    },
  },
  {
    id: 'rename-character',
    label: 'Rename the character',
    short: 'Rename',
    keys: [{ key: 'F2' }],
    isEnabled: hasActor,
    run: (editor) => {
      // On narrow pages the outliner is a sheet.
      editor.drawer.value = 'left';
      editor.renaming.value = selectedOf(editor)?.id ?? null;
    },
  },
  {
    id: 'hide-character',
    label: 'Hide or show the character',
    short: 'Hide',
    keys: [{ key: 'h' }],
    context: 'character',
    isEnabled: hasActor,
    run: toggleVisible,
  },
  nudgeCommand('nudge-left', 'Move left, turn left, or make smaller', 'ArrowLeft', 'right', -1),
  nudgeCommand('nudge-right', 'Move right, turn right, or make larger', 'ArrowRight', 'right', 1),
  nudgeCommand('nudge-ahead', 'Move away, lean back, or make larger', 'ArrowUp', 'ahead', 1),
  nudgeCommand('nudge-back', 'Move near, lean forward, or make smaller', 'ArrowDown', 'ahead', -1),
  nudgeCommand('nudge-up', 'Raise, lean to a side, or make larger', 'PageUp', 'up', 1),
  nudgeCommand(
    'nudge-down',
    'Lower, lean to the other side, or make smaller',
    'PageDown',
    'up',
    -1,
  ),
] as const satisfies readonly Command[];

function nudgeCommand<Id extends string>(
  id: Id,
  label: string,
  key: string,
  axis: Parameters<typeof nudge>[1],
  sign: 1 | -1,
) {
  return {
    id,
    label,
    keys: [{ key }],
    keyOnly: true,
    context: 'placing',
    run: (editor: Editor) => nudge(editor, axis, sign),
  } as const;
}

function selectedOf({ store, session }: Editor): Actor | undefined {
  return selectedActor(store, session);
}

/** Chooses a tool, or lays it down; the other things that a drag could do end. */
function chooseTool({ session }: Editor, tool: PlaceTool): void {
  const isOn = session.placeTool.value === tool;
  session.selectedJoint.value = null;
  session.activeDof.value = null;
  session.boneMode.value = false;
  session.firstPerson.value = false;
  session.placeTool.value = isOn ? null : tool;
}

async function setOnFloor({ store, evaluations, notice }: Editor): Promise<void> {
  await evaluations.settled();
  const shown = evaluations.selected();
  if (!shown) return;
  const { id, name, transform } = shown.state;
  const lowest = lowestPoint(shown);
  const [x, y, z] = transform.position;
  const position = [x, y - lowest, z] as const;
  const label = `Set ${name} on the floor`;
  if (Number.isFinite(lowest)) store.dispatch(setTransform(id, { ...transform, position }, label));
  notice.value = `${name} stands on the floor`;
}

/** The character may change its size many times over, so the camera frames it again. */
function toggleFitted(editor: Editor): void {
  const actor = selectedOf(editor);
  if (!actor) return;
  editor.store.dispatch(setFitted(actor, !actor.fitted));
  editor.frameOpened();
  editor.notice.value = actor.fitted
    ? `${actor.name} is shown in its file's own units and place`
    : `${actor.name} is fitted to one unit`;
}

function toggleVisible(editor: Editor): void {
  const actor = selectedOf(editor);
  if (!actor) return;
  const { visible } = actor.look;
  const label = `${visible ? 'Hide' : 'Show'} ${actor.name}`;
  editor.store.dispatch(setLook(actor.id, { visible: !visible }, label));
}
