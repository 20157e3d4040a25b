import { attempt } from '../attempt.ts';
import type { DialogId, Editor } from '../editor.ts';

/** A key combination. */
export interface KeyPress {
  /** As in `KeyboardEvent.key`; letters are lower case. */
  readonly key: string;
  /** With Ctrl, or Cmd on a Mac. */
  readonly control?: boolean;
  /** With Alt, or Option on a Mac. */
  readonly alt?: boolean;
  /** Whether Shift must be held; either way, if absent, except with Ctrl or Cmd. */
  readonly shift?: boolean;
}

/** The states in which a command's keys apply; see contexts.ts. */
export type ContextId =
  | 'first person'
  | 'timeline'
  | 'turning'
  | 'placing'
  | 'chain'
  | 'bone'
  | 'joint'
  | 'character'
  | 'everywhere'
  | 'control'
  | 'clipboard';

/**
 * Something that a user can do. Keys, buttons, rows of the controls, the help sheet and
 * docs/keys.md are made from these. To add one, add a row to a file of this folder.
 */
export interface Command {
  readonly id: string;
  /** The text of the help sheet and of a button's tooltip. */
  readonly label: string;
  /** The text of a button or a row, if the label is too long. */
  readonly short?: string;
  readonly keys?: readonly KeyPress[];
  /** Whether the browser makes events of these keys, such as `paste`, to which the page listens. */
  readonly byBrowser?: boolean;
  /** Whether it is only a key for what other commands do; the palette then leaves it out. */
  readonly keyOnly?: boolean;
  /** Everywhere if absent; keys with Ctrl or Cmd also apply in text fields. */
  readonly context?: ContextId;
  /** For a toggle: whether it is on. */
  readonly isOn?: (editor: Editor) => boolean;
  /** Whether the command can do anything; always, if absent. */
  readonly isEnabled?: (editor: Editor) => boolean;
  /** What the command would do now, if that is more specific than the label. */
  readonly describe?: (editor: Editor) => string;
  readonly run: (editor: Editor) => void | Promise<void>;
}

/** Runs a command; if it fails, the status line shows the message. */
export function runCommand({ run }: Command, editor: Editor): void {
  const work = run(editor);
  if (work) attempt(editor, work);
}

/** The key's name in the interface, such as "Ctrl/Cmd+Shift+Z". */
export function keyName({ key, control, alt, shift }: KeyPress): string {
  const names: Record<string, string> = {
    ' ': 'Space',
    ArrowLeft: '←',
    ArrowRight: '→',
    ArrowUp: '↑',
    ArrowDown: '↓',
    Escape: 'Esc',
  };
  const shown = names[key] ?? (control || shift ? key.toUpperCase() : key);
  const held = [control ? 'Ctrl/Cmd' : '', alt ? 'Alt' : '', shift ? 'Shift' : ''];
  return [...held, shown].filter(Boolean).join('+');
}

/** A button's tooltip: what the command would do, and its first key. */
export function titleOf(command: Command, editor: Editor): string {
  const [key] = command.keys ?? [];
  const text = command.describe?.(editor) ?? command.label;
  return key ? `${text} (${keyName(key)})` : text;
}

export function toggle(flag: { value: boolean }): void {
  flag.value = !flag.value;
}

export function toggleDialog({ dialog }: Editor, id: DialogId): void {
  dialog.value = dialog.value === id ? null : id;
}
