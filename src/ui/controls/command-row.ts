import { effect } from '@preact/signals-core';
import type { GUI } from 'lil-gui';
import { keyName, runCommand, titleOf } from '../commands/command.ts';
import { type CommandId, commandOf } from '../commands/registry.ts';
import type { Editor } from '../editor.ts';
import { field } from './signal-field.ts';

/** Adds a row that runs a command: a check box if the command is a toggle, otherwise a button. */
export function addCommandRow(folder: GUI, editor: Editor, id: CommandId): void {
  const command = commandOf(id);
  const { isOn } = command;
  const run = (): void => runCommand(command, editor);
  const row = isOn
    ? folder.add(
        field(() => isOn(editor), run),
        'value',
      )
    : folder.add({ run }, 'run');
  const [key] = command.keys ?? [];
  const name = command.short ?? command.label;
  row.name(isOn && key ? `${name} (${keyName(key)})` : name);
  row.domElement.title = titleOf(command, editor);
  if (!isOn) return;
  effect(() => {
    // Reading the state subscribes to it.
    isOn(editor);
    row.updateDisplay();
  });
}
