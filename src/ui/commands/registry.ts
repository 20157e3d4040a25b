import { cameraCommands } from './camera-commands.ts';
import { clipCommands } from './clip-commands.ts';
import type { Command } from './command.ts';
import { editCommands } from './edit-commands.ts';
import { fileCommands } from './file-commands.ts';
import { jointCommands } from './joint-commands.ts';
import { viewCommands } from './view-commands.ts';

const table = [
  ...viewCommands,
  ...fileCommands,
  ...editCommands,
  ...jointCommands,
  ...clipCommands,
  ...cameraCommands,
] as const;

export type CommandId = (typeof table)[number]['id'];

/** Every command, in the order of the help sheet. */
export const commands: readonly Command[] = table;

const byId = new Map(commands.map((command) => [command.id, command]));

export function commandOf(id: CommandId): Command {
  return byId.get(id)!;
}
