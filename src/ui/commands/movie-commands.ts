import { type Command, toggleDialog } from './command.ts';

/** Commands for pictures in motion. */
export const movieCommands = [
  {
    id: 'save-movie',
    label: 'Save a movie: video, GIF, turntable, pictures or meshes',
    short: 'Save a movie…',
    isOn: ({ dialog }) => dialog.value === 'movie',
    isEnabled: ({ store }) => store.scene.value.actors.length > 0,
    run: (editor) => toggleDialog(editor, 'movie'),
  },
] as const satisfies readonly Command[];
