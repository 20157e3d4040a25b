import { selectedActor } from '../../document/selected-actor.ts';
import { pictureExtensions } from '../../formats/extensions.ts';
import { poseFormats } from '../../formats/pose-formats.ts';
import { chooseFiles } from '../choose-files.ts';
import type { Editor } from '../editor.ts';
import { preparing, stopPreparing } from '../preparing.ts';
import { type Command, toggleDialog } from './command.ts';

const hasCharacter = ({ store }: Editor): boolean => store.scene.value.actors.length > 0;

const hasClip = ({ transport }: Editor): boolean => transport.clip !== undefined;

/** Commands that read or write files. */
export const fileCommands = [
  {
    id: 'new-scene',
    label: 'New, empty scene',
    short: 'New',
    isEnabled: hasCharacter,
    run: (editor) => editor.clearScene(),
  },
  {
    id: 'start-fresh',
    label: 'Start fresh, with the first scene',
    short: 'Start fresh',
    isEnabled: ({ scenes }) => scenes.length > 0,
    run: (editor) => editor.startFresh(),
  },
  {
    id: 'gallery',
    label: 'Add a character',
    short: 'Add…',
    isOn: ({ dialog }) => dialog.value === 'gallery',
    run: (editor) => toggleDialog(editor, 'gallery'),
  },
  {
    id: 'open-files',
    label: 'Open files',
    short: 'Open files…',
    run: (editor) => chooseFiles(editor, editor.fileExtensions),
  },
  {
    id: 'open-folder',
    label: 'Open a folder',
    short: 'Open folder…',
    run: (editor) => chooseFiles(editor, null),
  },
  {
    id: 'add-files',
    label: 'Add files to the scene',
    short: 'Add files…',
    run: (editor) => chooseFiles(editor, editor.fileExtensions, true),
  },
  {
    id: 'save-scene',
    label: 'Save the scene',
    short: 'Save scene',
    keys: [{ key: 's', control: true }],
    context: 'control',
    isEnabled: hasCharacter,
    run: (editor) => editor.saveScene(false),
  },
  {
    id: 'save-scene-as',
    label: 'Save the scene in another file',
    short: 'Save scene as…',
    keys: [{ key: 's', control: true, shift: true }],
    context: 'control',
    isEnabled: hasCharacter,
    run: (editor) => editor.saveScene(true),
  },
  {
    id: 'copy-link',
    label: 'Copy a link of the scene',
    short: 'Copy link',
    isEnabled: hasCharacter,
    run: (editor) => editor.copyLink(),
  },
  {
    id: 'cancel-work',
    label: 'Cancel the work in progress',
    short: 'Cancel',
    isEnabled: (editor) => editor.progress.value !== null || preparing(editor).length > 0,
    run: (editor) => {
      if (editor.progress.peek()) editor.cancelWork();
      else stopPreparing(editor);
    },
  },
  {
    id: 'open-pose',
    label: 'Open a pose',
    short: 'Open pose…',
    run: (editor) =>
      chooseFiles(
        editor,
        poseFormats.map(({ extension }) => extension),
      ),
  },
  {
    id: 'choose-image',
    label: 'Cover the selected character with an image',
    short: 'Choose an image…',
    isEnabled: ({ store, session }) => selectedActor(store, session) !== undefined,
    run: (editor) => chooseFiles(editor, pictureExtensions),
  },
  {
    id: 'save-pose',
    label: 'Save the pose',
    short: 'Save pose',
    run: (editor) => editor.savePose(),
  },
  {
    id: 'save-motion',
    label: 'Save the motion',
    short: 'Save motion',
    isEnabled: hasClip,
    run: (editor) => editor.saveMotion('json'),
  },
  {
    id: 'save-motion-anim',
    label: 'Save the motion as .anim',
    short: 'Save motion as .anim',
    isEnabled: hasClip,
    run: (editor) => editor.saveMotion('anim'),
  },
  {
    id: 'export-mesh',
    label: 'Export the posed mesh as OBJ',
    short: 'Export posed OBJ',
    run: (editor) => editor.exportMesh(),
  },
  {
    id: 'save-picture',
    label: 'Save a picture',
    short: 'Save (j)',
    keys: [{ key: 'j' }],
    run: (editor) => editor.savePicture('file'),
  },
  {
    id: 'copy-picture',
    label: 'Copy a picture',
    short: 'Copy',
    run: (editor) => editor.savePicture('clipboard'),
  },
  {
    id: 'save-passes',
    label: 'Save a picture and passes: depth, normals, joints, masks',
    short: 'Save with passes',
    run: (editor) => editor.savePicture('passes'),
  },
  {
    id: 'verify',
    label: 'Compare GPU with CPU',
    run: (editor) => editor.verify(),
  },
  {
    id: 'check-machine',
    label: 'Check this machine and save a report',
    short: 'Check this machine',
    run: (editor) => editor.checkMachine(),
  },
] as const satisfies readonly Command[];
