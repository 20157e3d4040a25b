import { runCommand, titleOf } from '../commands/command.ts';
import { type CommandId, commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';

interface CommandButtonProperties {
  readonly editor: Editor;
  readonly command: CommandId;
  readonly class?: string;
  /** A symbol instead of text; the command's label is then its accessible name. */
  readonly sign?: string;
  /** Runs before the command does. */
  readonly onRun?: () => void;
}

/**
 * A button that runs a command: pressed while a toggle is on, disabled while the command can do
 * nothing.
 */
export function CommandButton({
  editor,
  command: id,
  sign,
  onRun,
  ...rest
}: CommandButtonProperties) {
  const command = commandOf(id);
  const isPressed = sign === undefined ? command.isOn?.(editor) : undefined;
  return (
    <button
      type="button"
      class={rest.class}
      title={titleOf(command, editor)}
      aria-label={sign === undefined ? undefined : (command.describe?.(editor) ?? command.label)}
      aria-pressed={isPressed}
      disabled={command.isEnabled?.(editor) === false}
      onClick={() => {
        onRun?.();
        runCommand(command, editor);
      }}
    >
      {sign ?? command.short ?? command.label}
    </button>
  );
}
