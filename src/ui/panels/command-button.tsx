import { runCommand, titleOf } from '../commands/command.ts';
import { type CommandId, commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';

interface CommandButtonProperties {
  readonly editor: Editor;
  readonly command: CommandId;
  readonly class?: string;
  /** A sign instead of words; the command's label is then its name. */
  readonly sign?: string;
  /** Runs before the command does. */
  readonly onRun?: () => void;
}

/** A button that runs a command: pressed while that is on, disabled while there is nothing to do. */
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
