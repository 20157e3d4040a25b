import { runCommand, titleOf } from '../commands/command.ts';
import { type CommandId, commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import { Icon, type IconId } from './icon.tsx';

interface CommandButtonProperties {
  readonly editor: Editor;
  readonly command: CommandId;
  readonly class?: string;
  /** A symbol or an icon instead of text; the command's label is then its accessible name. */
  readonly sign?: string;
  readonly icon?: IconId;
  /** In a menu; a toggle there is checked while it is on. */
  readonly role?: 'menuitem' | 'menuitemcheckbox';
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
  icon,
  role,
  onRun,
  ...rest
}: CommandButtonProperties) {
  const command = commandOf(id);
  const hasText = sign === undefined && icon === undefined;
  // What says in its name what it would do next is no toggle.
  const isPressed = command.describe || role ? undefined : command.isOn?.(editor);
  return (
    <button
      type="button"
      class={rest.class}
      role={role}
      data-command={id}
      title={titleOf(command, editor)}
      aria-label={hasText ? undefined : (command.describe?.(editor) ?? command.label)}
      aria-pressed={isPressed}
      aria-checked={role === 'menuitemcheckbox' ? command.isOn?.(editor) : undefined}
      disabled={command.isEnabled?.(editor) === false}
      onClick={() => {
        onRun?.();
        runCommand(command, editor);
      }}
    >
      {icon ? <Icon id={icon} /> : (sign ?? command.short ?? command.label)}
    </button>
  );
}
