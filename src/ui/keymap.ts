import { resetJoint, setPose } from '../document/edits.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Session } from '../document/session.ts';
import { rollJoint } from '../posing/roll-joint.ts';
import { methods } from '../skinning/registry.ts';
import { firstPersonFrom, orbitFrom, walk } from '../view/first-person.ts';
import { orbit } from '../view/camera.ts';
import type { Editor, Looking } from './editor.ts';

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
/** Radians, as CS354's program. */
const rollStep = 0.1;
/** Scene units, in which a character is one tall. */
const walkStep = 0.05;

/** First person: the eye walks, in the scene's units. */
const firstPerson: readonly KeyBinding[] = [
  { key: 'w', label: 'Walk ahead', run: (editor) => step(editor, 1, 0) },
  { key: 's', label: 'Walk back', run: (editor) => step(editor, -1, 0) },
  { key: 'a', label: 'Walk left', run: (editor) => step(editor, 0, -1) },
  { key: 'd', label: 'Walk right', run: (editor) => step(editor, 0, 1) },
  { key: 'ArrowUp', label: 'Walk ahead', run: (editor) => step(editor, 1, 0) },
  { key: 'ArrowDown', label: 'Walk back', run: (editor) => step(editor, -1, 0) },
  { key: 'ArrowLeft', label: 'Walk left', run: (editor) => step(editor, 0, -1) },
  { key: 'ArrowRight', label: 'Walk right', run: (editor) => step(editor, 0, 1) },
];

/** Bone mode, with a joint that is lit or selected. */
const boneMode: readonly KeyBinding[] = [
  { key: 'ArrowLeft', label: 'Roll the bone to the left', run: (editor) => rollBone(editor, 1) },
  { key: 'ArrowRight', label: 'Roll the bone to the right', run: (editor) => rollBone(editor, -1) },
];

/** A joint is selected. */
const jointSelected: readonly KeyBinding[] = [
  { key: 'r', shift: true, label: 'Reset the joint', run: resetSelected },
];

/** No joint is selected: keys are for the whole character. */
const actorSelected: readonly KeyBinding[] = [
  { key: 'Delete', label: 'Remove the character', run: (editor) => editor.removeSelected() },
];

/** Keys that act everywhere but in text fields. */
const everywhere: readonly KeyBinding[] = [
  { key: 'a', label: 'Axes on, off', run: ({ session }) => toggle(session.showAxes) },
  { key: 's', label: 'Skin, skeleton, both', run: cycleDrawn },
  { key: 't', label: 'Translucent skin', run: ({ session }) => toggle(session.translucent) },
  { key: 'x', label: 'Compare methods side by side, on, off', run: toggleCompared },
  { key: 'j', label: 'Save a picture', run: savePicture },
  { key: 'r', label: 'Reset the pose', run: (editor) => editor.resetAll() },
  { key: '[', label: 'Previous joint', run: (editor) => stepJoint(editor, -1) },
  { key: ']', label: 'Next joint', run: (editor) => stepJoint(editor, 1) },
  {
    key: 'm',
    label: 'Bone mode: drags turn bones',
    run: ({ session }) => toggle(session.boneMode),
  },
  { key: 'c', label: 'First person on, off', run: ({ session }) => toggle(session.firstPerson) },
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
  { key: 'Escape', label: 'Cancel a drag; let the active value go', run: escape },
  { key: '?', label: 'These keys', run: ({ helpOpen }) => toggle(helpOpen) },
];

/** Keys with Ctrl or Cmd, which act in number fields too. */
export const withCommand: readonly KeyBinding[] = [
  { key: 'z', command: true, label: 'Undo', run: ({ store }) => store.undo() },
  { key: 'z', command: true, shift: true, label: 'Redo', run: ({ store }) => store.redo() },
  {
    key: 'd',
    command: true,
    label: 'Duplicate the character',
    run: (editor) => editor.duplicateSelected(),
  },
];

/** Keys that act in one state of the editor, before those that act everywhere. */
export interface KeyContext {
  readonly label: string;
  isActive(editor: Editor): boolean;
  readonly keys: readonly KeyBinding[];
}

/** Every context without Ctrl or Cmd; the first match wins. */
export const contexts: readonly KeyContext[] = [
  {
    label: 'First person',
    isActive: ({ session }) => session.firstPerson.value,
    keys: firstPerson,
  },
  {
    label: 'Bone mode, on a lit or selected joint',
    isActive: ({ session }) => session.boneMode.value && rolledJoint(session) !== null,
    keys: boneMode,
  },
  {
    label: 'A selected joint',
    isActive: ({ session }) => session.selectedJoint.value !== null,
    keys: jointSelected,
  },
  {
    label: 'No joint selected',
    isActive: ({ session }) => session.selectedJoint.value === null,
    keys: actorSelected,
  },
  { label: '', isActive: () => true, keys: everywhere },
];

/** What the pointer does on the view. */
export const pointerHelp: readonly (readonly [string, string])[] = [
  [
    'Left drag',
    'Orbit; in first person, look around; in bone mode, on a bone, turn it (Alt: roll)',
  ],
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
  const shown = names[key] ?? (command || shift ? key.toUpperCase() : key);
  return [command ? 'Ctrl/Cmd' : '', shift ? 'Shift' : '', shown].filter(Boolean).join('+');
}

function savePicture(editor: Editor): void {
  void editor.savePicture({ format: 'png', background: true, target: 'file' });
}

/** Selects the joint before or after the selected one, round and round. */
export function stepJoint({ store, session }: Looking, step: 1 | -1): void {
  const count = selectedActor(store, session)?.character.skeleton.jointCount ?? 0;
  if (count === 0) return;
  const { selectedJoint } = session;
  const from = selectedJoint.value ?? (step > 0 ? -1 : count);
  selectedJoint.value = (from + step + count) % count;
}

/** The joint that the arrows roll: the lit one, else the selected. */
function rolledJoint({ hoveredJoint, selectedJoint }: Session): number | null {
  return hoveredJoint.value ?? selectedJoint.value;
}

function rollBone({ store, session, evaluations }: Editor, direction: 1 | -1): void {
  const shown = evaluations.selected();
  const joint = rolledJoint(session);
  if (!shown || joint === null) return;
  const { id, character } = shown.state;
  const { skeleton, bones } = character;
  const bone = session.hoveredBone.value ?? bones.find((each) => each.joint === joint);
  if (bone?.joint !== joint) return;
  const q = rollJoint(skeleton, shown.pose.q, joint, bone.vector, direction * rollStep);
  store.dispatch(setPose(id, q, `Roll ${skeleton.names[joint]!}`));
}

function resetSelected({ store, session, evaluations }: Editor): void {
  const shown = evaluations.selected();
  const joint = session.selectedJoint.value;
  if (shown && joint !== null) store.dispatch(resetJoint(shown.state, shown.pose.q, joint));
}

/** Takes back the nearest thing: a drag, else the active value, which drags would set alone. */
function escape({ store, session }: Editor): void {
  if (!store.cancelGesture()) session.activeDof.value = null;
}

function step({ viewer: { camera } }: Editor, ahead: number, right: number): void {
  const view = firstPersonFrom(camera.value);
  camera.value = orbitFrom(walk(view, ahead * walkStep, right * walkStep, 0));
}

function toggle(flag: { value: boolean }): void {
  flag.value = !flag.value;
}

/** Beside the selected actor's method the first other one. */
function toggleCompared({ store, session }: Editor): void {
  const { comparedKernel } = session;
  const actor = selectedActor(store, session);
  const other = methods.find(({ id }) => id !== actor?.method);
  comparedKernel.value = comparedKernel.value === null && other ? other.id : null;
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
