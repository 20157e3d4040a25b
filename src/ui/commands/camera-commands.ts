import { orbit } from '../../view/camera-moves.ts';
import { firstPersonFrom, orbitFrom, walk } from '../../view/first-person.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

/** In radians. */
const orbitStep = Math.PI / 12;
/** In scene units; a character is one unit tall. */
const walkStep = 0.05;

/** Commands for the camera: orbiting the character, or walking in first person. */
export const cameraCommands = [
  {
    id: 'frame',
    label: 'Frame the character',
    short: 'Frame',
    keys: [{ key: 'Home' }],
    run: ({ viewer }) => viewer.frameAll(),
  },
  {
    id: 'play-or-reset-camera',
    label: 'Reset the camera; while a clip is bound, play or pause it',
    keys: [{ key: ' ' }],
    keyOnly: true,
    run: (editor) => {
      if (editor.transport.isBound) editor.transport.togglePlay();
      else editor.resetCamera();
    },
  },
  {
    id: 'reset-camera',
    label: "Reset the camera to the workspace's position",
    short: 'Reset camera',
    run: (editor) => editor.resetCamera(),
  },
  {
    id: 'orbit-left',
    label: 'Orbit left',
    keys: [{ key: 'ArrowLeft' }],
    run: (editor) => turn(editor, -1, 0),
  },
  {
    id: 'orbit-right',
    label: 'Orbit right',
    keys: [{ key: 'ArrowRight' }],
    run: (editor) => turn(editor, 1, 0),
  },
  {
    id: 'orbit-up',
    label: 'Orbit up',
    keys: [{ key: 'ArrowUp' }],
    run: (editor) => turn(editor, 0, 1),
  },
  {
    id: 'orbit-down',
    label: 'Orbit down',
    keys: [{ key: 'ArrowDown' }],
    run: (editor) => turn(editor, 0, -1),
  },
  {
    id: 'walk-ahead',
    label: 'Walk forward',
    keys: [{ key: 'w' }, { key: 'ArrowUp' }],
    context: 'first person',
    run: (editor) => step(editor, 1, 0),
  },
  {
    id: 'walk-back',
    label: 'Walk back',
    keys: [{ key: 's' }, { key: 'ArrowDown' }],
    context: 'first person',
    run: (editor) => step(editor, -1, 0),
  },
  {
    id: 'walk-left',
    label: 'Walk left',
    keys: [{ key: 'a' }, { key: 'ArrowLeft' }],
    context: 'first person',
    run: (editor) => step(editor, 0, -1),
  },
  {
    id: 'walk-right',
    label: 'Walk right',
    keys: [{ key: 'd' }, { key: 'ArrowRight' }],
    context: 'first person',
    run: (editor) => step(editor, 0, 1),
  },
] as const satisfies readonly Command[];

function turn({ viewer: { camera } }: Editor, right: number, up: number): void {
  camera.value = orbit(camera.value, right * orbitStep, up * orbitStep);
}

function step({ viewer: { camera } }: Editor, ahead: number, right: number): void {
  const view = firstPersonFrom(camera.value);
  camera.value = orbitFrom(walk(view, ahead * walkStep, right * walkStep, 0));
}
