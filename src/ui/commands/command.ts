import { attempt } from '../attempt.ts';
import type { Editor } from '../editor.ts';

/** A press of a key. */
export interface KeyPress {
  /** As `KeyboardEvent.key`; letters lower case. */
  readonly key: string;
  /** With Ctrl, or Cmd on a Mac. */
  readonly control?: boolean;
  readonly shift?: boolean;
}

/** Where a command's keys act; see contexts.ts. */
export type ContextId =
  'first person' | 'timeline' | 'bone' | 'joint' | 'character' | 'everywhere' | 'control';

/**
 * A seam: something that a user can do. Keys, buttons, rows of the controls, the help sheet and
 * docs/keys.md are views of these. A new one is a row in a file of this folder.
 */
export interface Command {
  readonly id: string;
  /** What it does, for the help sheet and as a button's title. */
  readonly label: string;
  /** On a button or a row, where the label is too long. */
  readonly short?: string;
  readonly keys?: readonly KeyPress[];
  /** Everywhere where absent; with Ctrl or Cmd, in fields too. */
  readonly context?: ContextId;
  /** Of a switch: whether it is on. */
  readonly isOn?: (editor: Editor) => boolean;
  /** Whether there is something to do; always where absent. */
  readonly isEnabled?: (editor: Editor) => boolean;
  /** What it would do now, where that is more than the label says. */
  readonly describe?: (editor: Editor) => string;
  readonly run: (editor: Editor) => void | Promise<void>;
}

/** Runs a command; where it fails, the status line says so. */
export function runCommand({ run }: Command, editor: Editor): void {
  const work = run(editor);
  if (work) attempt(editor, work);
}

/** "Ctrl/Cmd+Shift+Z", for people. */
export function keyName({ key, control, shift }: KeyPress): string {
  const names: Record<string, string> = {
    ' ': 'Space',
    ArrowLeft: '←',
    ArrowRight: '→',
    ArrowUp: '↑',
    ArrowDown: '↓',
    Escape: 'Esc',
  };
  const shown = names[key] ?? (control || shift ? key.toUpperCase() : key);
  return [control ? 'Ctrl/Cmd' : '', shift ? 'Shift' : '', shown].filter(Boolean).join('+');
}

/** What a button's tooltip says: what it would do, and its first key. */
export function titleOf(command: Command, editor: Editor): string {
  const [key] = command.keys ?? [];
  const text = command.describe?.(editor) ?? command.label;
  return key ? `${text} (${keyName(key)})` : text;
}

export function toggle(flag: { value: boolean }): void {
  flag.value = !flag.value;
}
