import { loadPart } from '../../core/failure.ts';
import type { Transport } from '../../document/transport.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { shownState } from '../../evaluation/shown-state.ts';
import type { Editor } from '../editor.ts';
import { type Command, toggle } from './command.ts';

const hasClip = ({ transport }: Editor): boolean => transport.clip !== undefined;

/** These act on the bound clip, or on the clip that Play would bind. */
export const clipCommands = [
  {
    id: 'play',
    label: 'Play or pause the clip',
    keys: [{ key: 'p' }],
    isOn: ({ session }) => session.playing.value,
    describe: ({ session }) => (session.playing.value ? 'Pause' : 'Play'),
    isEnabled: (editor) => hasClip(editor) || editor.session.playing.value,
    run: (editor) => play(editor, (transport) => transport.togglePlay()),
  },
  {
    id: 'play-here',
    label: 'Play or pause',
    keys: [{ key: ' ' }],
    keyOnly: true,
    context: 'timeline',
    isEnabled: hasClip,
    run: (editor) => play(editor, (transport) => transport.togglePlay()),
  },
  {
    id: 'clip-start',
    label: 'Go to the start',
    keys: [{ key: 'Home' }],
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ transport }) => transport.seek(transport.clip?.start ?? 0),
  },
  {
    id: 'clip-end',
    label: 'Go to the end',
    keys: [{ key: 'End' }],
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ transport }) => transport.seek(transport.clip?.end ?? 0),
  },
  {
    id: 'step-back',
    label: 'Step back',
    keys: [{ key: 'ArrowLeft' }],
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ transport }) => transport.step(-1),
  },
  {
    id: 'step-on',
    label: 'Step forward',
    keys: [{ key: 'ArrowRight' }],
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ transport }) => transport.step(1),
  },
  {
    id: 'play-all',
    label: 'Play all characters together',
    isEnabled: ({ store }) => store.scene.value.actors.some(({ clips }) => clips.length > 0),
    run: (editor) => play(editor, (transport) => transport.playAll()),
  },
  {
    id: 'release-clip',
    label: 'Release the clip: what is shown becomes the pose',
    short: 'Release the clip',
    isEnabled: ({ transport }) => transport.isBound,
    run: release,
  },
  {
    id: 'new-clip',
    label: 'New clip',
    isEnabled: ({ store, session }) => selectedActor(store, session) !== undefined,
    run: async (editor) => (await clips()).makeClip(editor),
  },
  {
    id: 'duplicate-clip',
    label: 'Duplicate the clip',
    short: 'Duplicate',
    isEnabled: hasClip,
    run: async (editor) => (await clips()).copyClip(editor),
  },
  {
    id: 'delete-clip',
    label: 'Delete the clip',
    short: 'Delete',
    isEnabled: hasClip,
    run: async (editor) => (await clips()).deleteClip(editor),
  },
  {
    id: 'clip-settings',
    label: 'Clip settings: name, length and frames a second',
    short: 'Clip settings',
    isEnabled: hasClip,
    run: async (editor) => (await clips()).openClipSettings(editor),
  },
  {
    id: 'snap-to-frames',
    label: 'Snap times to frames',
    isOn: ({ session }) => session.snapsToFrames.value,
    run: ({ session }) => toggle(session.snapsToFrames),
  },
  {
    id: 'work-range-start',
    label: 'Start the work range at the playhead',
    isEnabled: hasClip,
    run: async (editor) => (await clips()).setWorkRange(editor, 'start'),
  },
  {
    id: 'work-range-end',
    label: 'End the work range at the playhead',
    isEnabled: hasClip,
    run: async (editor) => (await clips()).setWorkRange(editor, 'end'),
  },
  {
    id: 'whole-range',
    label: 'Clear the work range: the whole clip plays',
    short: 'Clear the work range',
    isEnabled: ({ session }) => session.workRange.value !== null,
    run: ({ session }) => void (session.workRange.value = null),
  },
] as const satisfies readonly Command[];

function release({ transport, evaluations }: Editor): void {
  const shown = evaluations.selected();
  if (shown) transport.release(shownState(shown));
}

function clips() {
  return loadPart(import('../clips.ts'));
}

/** Plays or pauses. Whoever gets up as a clip is bound stays in the picture. */
async function play(editor: Editor, toggle: (transport: Transport) => void): Promise<void> {
  const { scene } = editor.store;
  const bound = (): number => scene.peek().actors.filter(({ clip }) => clip !== null).length;
  const before = bound();
  toggle(editor.transport);
  if (bound() <= before) return;
  const { keepInPicture } = await loadPart(import('../keep-in-picture.ts'));
  await keepInPicture(editor);
}
