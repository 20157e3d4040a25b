import { loadPart } from '../../core/failure.ts';
import type { Editor } from '../editor.ts';
import { copiedKeys, setTimeUnit, showsAllJoints, timeUnit } from '../timeline/timeline-state.ts';
import { type Command, toggle } from './command.ts';

const hasClip = ({ transport }: Editor): boolean => transport.clip !== undefined;
const hasKeys = ({ session }: Editor): boolean => session.selectedKeys.value.size > 0;
const hasCopied = (editor: Editor): boolean => hasClip(editor) && copiedKeys.value !== null;
const edits = () => loadPart(import('../timeline/edit-keys.ts'));

/** Commands for the keys of the clip that the timeline shows, and for how it shows them. */
export const timelineCommands = [
  {
    id: 'previous-key',
    label: 'Go to the previous key',
    keys: [{ key: ',' }],
    isEnabled: hasClip,
    run: async (editor) => (await edits()).goToKey(editor, -1),
  },
  {
    id: 'next-key',
    label: 'Go to the next key',
    keys: [{ key: '.' }],
    isEnabled: hasClip,
    run: async (editor) => (await edits()).goToKey(editor, 1),
  },
  {
    id: 'all-keys',
    label: 'Select all keys',
    keys: [{ key: 'a', control: true }],
    context: 'timeline',
    isEnabled: hasClip,
    run: async (editor) => (await edits()).selectAllKeys(editor),
  },
  {
    id: 'remove-keys',
    label: 'Delete the selected keys',
    short: 'Remove',
    keys: [{ key: 'Delete' }, { key: 'Backspace' }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).removeSelectedKeys(editor),
  },
  {
    id: 'copy-keys',
    label: 'Copy the selected keys',
    short: 'Copy',
    keys: [{ key: 'c', control: true }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).copySelectedKeys(editor),
  },
  {
    id: 'cut-keys',
    label: 'Cut the selected keys',
    short: 'Cut',
    keys: [{ key: 'x', control: true }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).cutSelectedKeys(editor),
  },
  {
    id: 'paste-keys',
    label: 'Paste keys at the playhead',
    short: 'Paste here',
    keys: [{ key: 'v', control: true }],
    context: 'timeline',
    isEnabled: hasCopied,
    run: async (editor) => (await edits()).pasteAtPlayhead(editor, { reversed: false }),
  },
  {
    id: 'paste-keys-reversed',
    label: 'Paste keys at the playhead, the last one first',
    short: 'Paste reversed',
    keys: [{ key: 'v', control: true, shift: true }],
    context: 'timeline',
    isEnabled: hasCopied,
    run: async (editor) => (await edits()).pasteAtPlayhead(editor, { reversed: true }),
  },
  {
    id: 'duplicate-keys',
    label: 'Duplicate the selected keys, at the playhead',
    short: 'Duplicate',
    keys: [{ key: 'd', control: true }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).duplicateKeys(editor),
  },
  {
    id: 'keys-earlier',
    label: 'Move the selected keys a frame earlier',
    keys: [{ key: 'ArrowLeft', alt: true }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).nudgeKeys(editor, -1),
  },
  {
    id: 'keys-later',
    label: 'Move the selected keys a frame later',
    keys: [{ key: 'ArrowRight', alt: true }],
    context: 'timeline',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).nudgeKeys(editor, 1),
  },
  {
    id: 'frame-keys',
    label: 'Frame the selected keys, or all',
    short: 'Frame the keys',
    keys: [{ key: 'f', shift: false }],
    context: 'timeline',
    isEnabled: hasClip,
    run: async (editor) => (await edits()).frameKeys(editor),
  },
  {
    id: 'frame-clip',
    label: 'Frame the whole clip',
    short: 'Frame the clip',
    keys: [{ key: 'f', shift: true }],
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ session }) => {
      session.timeWindow.value = null;
    },
  },
  {
    id: 'work-range-keys',
    label: 'Play the selected keys only',
    short: 'Work range of the keys',
    isEnabled: hasKeys,
    run: async (editor) => (await edits()).workRangeOfKeys(editor),
  },
  {
    id: 'time-in-frames',
    label: 'Write times as frames, not as seconds',
    short: 'Frames',
    isOn: () => timeUnit.value === 'frames',
    run: () => setTimeUnit(timeUnit.value === 'frames' ? 'seconds' : 'frames'),
  },
  {
    id: 'all-joints-in-timeline',
    label: 'Rows for all joints in the timeline, also those that the clip does not move',
    short: 'All joints',
    isOn: () => showsAllJoints.value,
    run: () => toggle(showsAllJoints),
  },
] as const satisfies readonly Command[];
