import { selectedCharacter } from '../document/document.ts';
import { orbit } from '../view/camera.ts';
import type { Editor } from './editor.ts';

/** A key of a context, with what it does. */
export interface KeyBinding {
  /** As `KeyboardEvent.key`; letters lower case. */
  readonly key: string;
  /** With Ctrl, or Cmd on a Mac. */
  readonly command?: boolean;
  readonly shift?: boolean;
  readonly label: string;
  run(editor: Editor): void;
}

const orbitStep = Math.PI / 12;

/** Keys that act everywhere but in text fields. */
export const everywhere: readonly KeyBinding[] = [
  { key: 'a', label: 'Axes on, off', run: ({ session }) => toggle(session.showAxes) },
  { key: 's', label: 'Skin, skeleton, both', run: cycleDrawn },
  { key: 't', label: 'Translucent skin', run: ({ session }) => toggle(session.translucent) },
  { key: 'j', label: 'Save a picture', run: savePicture },
  { key: 'r', label: 'Reset the pose', run: (editor) => editor.resetAll() },
  { key: '[', label: 'Previous joint', run: (editor) => stepJoint(editor, -1) },
  { key: ']', label: 'Next joint', run: (editor) => stepJoint(editor, 1) },
  { key: 'p', label: 'Play, pause the clip', run: ({ transport }) => transport.togglePlay() },
  { key: 'Home', label: 'Frame the character', run: ({ viewer }) => viewer.frameAll() },
  {
    key: ' ',
    label: 'Reset the camera; with a bound clip, play or pause',
    run: (editor) => {
      if (editor.transport.isBound) editor.transport.togglePlay();
      else editor.setWorkspace(editor.workspaceId.value);
    },
  },
  { key: 'ArrowLeft', label: 'Orbit left', run: (editor) => turn(editor, -1, 0) },
  { key: 'ArrowRight', label: 'Orbit right', run: (editor) => turn(editor, 1, 0) },
  { key: 'ArrowUp', label: 'Orbit up', run: (editor) => turn(editor, 0, 1) },
  { key: 'ArrowDown', label: 'Orbit down', run: (editor) => turn(editor, 0, -1) },
  { key: 'Escape', label: 'Cancel a drag', run: ({ store }) => void store.cancelGesture() },
  { key: '?', label: 'These keys', run: ({ helpOpen }) => toggle(helpOpen) },
];

/** Keys with Ctrl or Cmd, which act in number fields too. */
export const withCommand: readonly KeyBinding[] = [
  { key: 'z', command: true, label: 'Undo', run: ({ store }) => store.undo() },
  { key: 'z', command: true, shift: true, label: 'Redo', run: ({ store }) => store.redo() },
];

/** What the pointer does on the view. */
export const pointerHelp: readonly (readonly [string, string])[] = [
  ['Left drag', 'Orbit'],
  ['Middle drag', 'Move sideways'],
  ['Right drag, wheel', 'Zoom'],
];

/** "Ctrl+Shift+Z", for people. */
export function keyName({ key, command, shift }: KeyBinding): string {
  const names: Record<string, string> = {
    ' ': 'Space',
    ArrowLeft: '←',
    ArrowRight: '→',
    ArrowUp: '↑',
    ArrowDown: '↓',
    Escape: 'Esc',
  };
  const shown = names[key] ?? (command ? key.toUpperCase() : key);
  return [command ? 'Ctrl/Cmd' : '', shift ? 'Shift' : '', shown].filter(Boolean).join('+');
}

function savePicture(editor: Editor): void {
  void editor.savePicture({ format: 'png', background: true, target: 'file' });
}

/** Selects the joint before or after the selected one, round and round. */
export function stepJoint({ store, session }: Editor, step: 1 | -1): void {
  const count = selectedCharacter(store.document.value)?.character.skeleton.jointCount ?? 0;
  if (count === 0) return;
  const { selectedJoint } = session;
  const from = selectedJoint.value ?? (step > 0 ? -1 : count);
  selectedJoint.value = (from + step + count) % count;
}

function toggle(flag: { value: boolean }): void {
  flag.value = !flag.value;
}

/** Skin alone, skeleton alone, both, and round again. */
function cycleDrawn({ session: { showSkin, showSkeleton } }: Editor): void {
  if (showSkin.value && showSkeleton.value) showSkeleton.value = false;
  else if (showSkin.value) [showSkin.value, showSkeleton.value] = [false, true];
  else [showSkin.value, showSkeleton.value] = [true, true];
}

function turn({ viewer: { camera } }: Editor, right: number, up: number): void {
  camera.value = orbit(camera.value, right * orbitStep, up * orbitStep);
}
