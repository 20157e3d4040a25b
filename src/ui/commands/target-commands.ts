import type { Editor } from '../editor.ts';
import { nudgeTarget, type TargetAxis } from '../nudge-target.ts';
import type { Command } from './command.ts';

/** The keys that move the target of the selected joint's chain, as the picture shows it. */
export const targetCommands = [
  ...nudges('target-left', 'Move the target left', 'ArrowLeft', 'right', -1),
  ...nudges('target-right', 'Move the target right', 'ArrowRight', 'right', 1),
  ...nudges('target-up', 'Move the target up', 'ArrowUp', 'up', 1),
  ...nudges('target-down', 'Move the target down', 'ArrowDown', 'up', -1),
  ...nudges('target-away', 'Move the target away', 'PageUp', 'look', 1),
  ...nudges('target-near', 'Move the target nearer', 'PageDown', 'look', -1),
] as const satisfies readonly Command[];

/** The command of a key, and that of the same key with Shift for a tenth of the way. */
function nudges<Id extends string>(
  id: Id,
  label: string,
  key: string,
  axis: TargetAxis,
  sign: 1 | -1,
) {
  const shared = { keyOnly: true, context: 'chain' } as const;
  return [
    {
      ...{ id, label, ...shared },
      keys: [{ key, shift: false }],
      run: (editor: Editor) => nudgeTarget(editor, axis, sign, false),
    },
    {
      ...{ id: `${id}-finely`, label: `${label} by a tenth of that`, ...shared },
      keys: [{ key, shift: true }],
      run: (editor: Editor) => nudgeTarget(editor, axis, sign, true),
    },
  ] as const;
}
