import { libraryCommands } from './library-commands.ts';
import { axisCommands } from './axis-commands.ts';
import { cameraCommands } from './camera-commands.ts';
import { clipCommands } from './clip-commands.ts';
import type { Command } from './command.ts';
import { curveCommands } from './curve-commands.ts';
import { deformLabCommands } from './deform-lab-commands.ts';
import { cuttingCommands } from './cutting-commands.ts';
import { editCommands } from './edit-commands.ts';
import { fileCommands } from './file-commands.ts';
import { ikCommands } from './ik-commands.ts';
import { ikLabCommands } from './ik-lab-commands.ts';
import { jointCommands } from './joint-commands.ts';
import { keyCommands } from './key-commands.ts';
import { movieCommands } from './movie-commands.ts';
import { motionViewCommands } from './motion-view-commands.ts';
import { measureCommands } from './measure-commands.ts';
import { pinCommands } from './pin-commands.ts';
import { poseCommands } from './pose-commands.ts';
import { rotationLabCommands } from './rotation-lab-commands.ts';
import { shotCommands } from './shot-commands.ts';
import { placeCommands } from './place-commands.ts';
import { turnCommands } from './turn-commands.ts';
import { targetCommands } from './target-commands.ts';
import { timelineCommands } from './timeline-commands.ts';
import { vertexCommands } from './vertex-commands.ts';
import { viewCommands } from './view-commands.ts';
import { weightCommands } from './weight-commands.ts';

/** Every command by the file it stands in, in the order of the help sheet. */
const groups = [
  { label: 'View', commands: viewCommands },
  { label: 'Files', commands: fileCommands },
  { label: 'Edit', commands: editCommands },
  { label: 'Character', commands: placeCommands },
  { label: 'Joints', commands: [...jointCommands, ...turnCommands] },
  { label: 'Inverse kinematics', commands: [...ikCommands, ...targetCommands, ...ikLabCommands] },
  { label: 'Pins', commands: pinCommands },
  { label: 'Pose', commands: poseCommands },
  { label: 'Pose library', commands: libraryCommands },
  { label: 'Clip', commands: clipCommands },
  { label: 'Keys', commands: keyCommands },
  { label: 'Timeline', commands: timelineCommands },
  { label: 'Curves', commands: curveCommands },
  { label: 'Movie', commands: movieCommands },
  { label: 'Motion in the view', commands: motionViewCommands },
  { label: 'Rotations', commands: rotationLabCommands },
  { label: 'Weights', commands: [...weightCommands, ...vertexCommands] },
  { label: 'Deformation', commands: [...deformLabCommands, ...measureCommands] },
  { label: 'Cutting figure', commands: cuttingCommands },
  { label: 'Camera', commands: [...cameraCommands, ...axisCommands] },
  { label: 'Shots', commands: shotCommands },
] as const;

export type CommandId = (typeof groups)[number]['commands'][number]['id'];

/** A file of commands, as a group of the command palette. */
export interface CommandGroup {
  readonly label: string;
  readonly commands: readonly Command[];
}

export const commandGroups: readonly CommandGroup[] = groups;

/** Every command, in the order of the help sheet. */
export const commands: readonly Command[] = commandGroups.flatMap(({ commands }) => commands);

const byId = new Map(commands.map((command) => [command.id, command]));

export function commandOf(id: CommandId): Command {
  return byId.get(id)!;
}
