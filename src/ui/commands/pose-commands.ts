import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import type { FromSide } from '../mirroring.ts';
import { copyPose } from '../pose-clipboard.ts';
import type { Command } from './command.ts';

/** Commands that copy, paste and mirror poses. */
export const poseCommands = [
  {
    id: 'copy-pose',
    label: 'Copy the pose, or that of the selected joints',
    short: 'Copy pose',
    keys: [{ key: 'c', control: true }],
    byBrowser: true,
    context: 'clipboard',
    isEnabled: hasJoints,
    run: copyPose,
  },
  {
    id: 'paste-pose',
    label: 'Paste a pose onto the joints that it names, or files',
    short: 'Paste pose',
    keys: [{ key: 'v', control: true }],
    byBrowser: true,
    context: 'clipboard',
    isEnabled: hasJoints,
    run: (editor) => paste(editor, false),
  },
  {
    id: 'paste-mirrored',
    label: 'Paste a pose mirrored',
    short: 'Paste mirrored',
    keys: [{ key: 'v', control: true, shift: true }],
    byBrowser: true,
    context: 'clipboard',
    isEnabled: hasJoints,
    run: (editor) => paste(editor, true),
  },
  {
    id: 'mirror-pose',
    label: 'Mirror the pose: left and right change places',
    short: 'Mirror',
    isEnabled: hasJoints,
    run: async (editor) => (await mirroring()).mirrorInPlace(editor),
  },
  {
    id: 'left-onto-right',
    label: 'Mirror the left side onto the right one',
    short: 'Left → right',
    isEnabled: hasJoints,
    run: (editor) => onto(editor, 'left'),
  },
  {
    id: 'right-onto-left',
    label: 'Mirror the right side onto the left one',
    short: 'Right → left',
    isEnabled: hasJoints,
    run: (editor) => onto(editor, 'right'),
  },
  {
    id: 'live-symmetry',
    label: 'Live symmetry: what poses one side poses the other one too',
    short: 'Live symmetry',
    isOn: ({ session }) => session.liveSymmetry.value,
    run: toggleSymmetry,
  },
] as const satisfies readonly Command[];

function hasJoints({ store, session }: Editor): boolean {
  return (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0;
}

async function paste(editor: Editor, isMirrored: boolean): Promise<void> {
  const { pastePose } = await loadPart(import('../paste-pose.ts'));
  await pastePose(editor, isMirrored);
}

async function onto(editor: Editor, from: FromSide): Promise<void> {
  (await mirroring()).mirrorOnto(editor, from);
}

function mirroring() {
  return loadPart(import('../mirroring.ts'));
}

async function toggleSymmetry(editor: Editor): Promise<void> {
  const { hasSides, setLiveSymmetry } = await loadPart(import('../live-symmetry.ts'));
  const isOn = !editor.session.liveSymmetry.value;
  setLiveSymmetry(editor, isOn);
  if (!isOn) editor.notice.value = 'Each side is posed alone';
  else if (hasSides(editor)) editor.notice.value = 'Live symmetry: both sides are posed alike';
  else editor.notice.value = 'Live symmetry is on, but no left and right were found here';
}
