import type { Editor } from '../editor.ts';
import { stepAxis, turnByKey } from '../turn-by-keys.ts';
import { type Command, toggle } from './command.ts';

const hasJoint = ({ session }: Editor): boolean => session.selectedJoint.value !== null;

/** Commands for the selected joints: their axes, and turning them by keys. */
export const turnCommands = [
  {
    id: 'ring-axes',
    label: "Turn joints by rings about their own axes, or the scene's",
    short: 'Own axes',
    keys: [{ key: 'q' }],
    context: 'joint',
    isOn: ({ session }) => session.ringAxes.value === 'local',
    isEnabled: hasJoint,
    run: ({ session }) => {
      session.ringAxes.value = session.ringAxes.value === 'local' ? 'world' : 'local';
    },
  },
  {
    id: 'select-several',
    label: 'Select several joints: a click adds one, or takes it out',
    short: 'Select several',
    isOn: ({ session }) => session.selectsSeveral.value,
    run: ({ session }) => toggle(session.selectsSeveral),
  },
  turnCommand('turn-back', 'Turn the active axis back by 5°', 'ArrowLeft', -1, false),
  turnCommand('turn-on', 'Turn the active axis by 5°', 'ArrowRight', 1, false),
  turnCommand('turn-back-fine', 'Turn the active axis back by 0.5°', 'ArrowLeft', -1, true),
  turnCommand('turn-on-fine', 'Turn the active axis by 0.5°', 'ArrowRight', 1, true),
  axisCommand('previous-axis', 'Make the previous axis the active one', 'ArrowUp', -1),
  axisCommand('next-axis', 'Make the next axis the active one', 'ArrowDown', 1),
] as const satisfies readonly Command[];

function turnCommand<Id extends string>(
  id: Id,
  label: string,
  key: string,
  sign: 1 | -1,
  isFine: boolean,
) {
  return {
    ...{ id, label },
    keys: [{ key, alt: true, shift: isFine }],
    keyOnly: true,
    context: 'turning',
    run: (editor: Editor) => turnByKey(editor, sign, isFine),
  } as const;
}

function axisCommand<Id extends string>(id: Id, label: string, key: string, step: 1 | -1) {
  return {
    ...{ id, label },
    keys: [{ key, alt: true }],
    keyOnly: true,
    context: 'turning',
    run: (editor: Editor) => stepAxis(editor, step),
  } as const;
}
