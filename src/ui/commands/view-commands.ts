import type { Editor } from '../editor.ts';
import { type Command, toggle, toggleDialog } from './command.ts';

/** Commands for what is shown, and for what drags do. */
export const viewCommands = [
  {
    id: 'axes',
    label: 'Show or hide the axes',
    short: 'Axes',
    keys: [{ key: 'a' }],
    isOn: ({ session }) => session.showAxes.value,
    run: ({ session }) => toggle(session.showAxes),
  },
  {
    id: 'drawn',
    label: 'Show the skin, the skeleton, or both',
    keys: [{ key: 's' }],
    run: cycleDrawn,
  },
  {
    id: 'skin',
    label: 'Show or hide the skin',
    short: 'Skin',
    isOn: ({ session }) => session.showSkin.value,
    run: ({ session }) => toggle(session.showSkin),
  },
  {
    id: 'skeleton',
    label: 'Show or hide the skeleton',
    short: 'Skeleton',
    isOn: ({ session }) => session.showSkeleton.value,
    run: ({ session }) => toggle(session.showSkeleton),
  },
  {
    id: 'translucent',
    label: 'Translucent skin',
    short: 'Translucent',
    keys: [{ key: 't' }],
    isOn: ({ session }) => session.translucent.value,
    run: ({ session }) => toggle(session.translucent),
  },
  {
    id: 'normal-lines',
    label: 'Show or hide the normals as lines',
    short: 'Normals as lines',
    isOn: ({ session }) => session.showNormals.value,
    run: ({ session }) => toggle(session.showNormals),
  },
  {
    id: 'bone-mode',
    label: 'Bone mode: drag any limb to turn it, without selecting it',
    short: 'Bone mode',
    keys: [{ key: 'm' }],
    isOn: ({ session }) => session.boneMode.value,
    run: ({ session }) => toggle(session.boneMode),
  },
  {
    id: 'drag-lights',
    label: 'Drag the lights in the view, or put their handles away',
    short: 'Drag the lights',
    keys: [{ key: 'u' }],
    isOn: ({ session }) => session.dragsLights.value,
    run: ({ session }) => toggle(session.dragsLights),
  },
  {
    id: 'first-person',
    label: 'First-person camera on or off',
    short: 'First person',
    keys: [{ key: 'c' }],
    isOn: ({ session }) => session.firstPerson.value,
    run: toggleFirstPerson,
  },
  {
    id: 'keys',
    label: 'Show all keys',
    short: 'Keys',
    keys: [{ key: '?' }],
    isOn: ({ dialog }) => dialog.value === 'keys',
    run: (editor) => toggleDialog(editor, 'keys'),
  },
  {
    id: 'palette',
    label: 'Search the commands',
    short: 'Search…',
    keys: [{ key: 'k', control: true }],
    context: 'control',
    isOn: ({ dialog }) => dialog.value === 'palette',
    // The palette does not list itself.
    isEnabled: ({ dialog }) => dialog.value !== 'palette',
    run: (editor) => toggleDialog(editor, 'palette'),
  },
] as const satisfies readonly Command[];

/** Walking needs perspective. */
function toggleFirstPerson({ session: { firstPerson }, viewer: { camera } }: Editor): void {
  toggle(firstPerson);
  if (firstPerson.value) camera.value = { ...camera.value, projection: 'perspective' };
}

/** Cycles through skin only, skeleton only, and both. */
function cycleDrawn({ session: { showSkin, showSkeleton } }: Editor): void {
  if (showSkin.value && showSkeleton.value) showSkeleton.value = false;
  else if (showSkin.value) [showSkin.value, showSkeleton.value] = [false, true];
  else [showSkin.value, showSkeleton.value] = [true, true];
}
