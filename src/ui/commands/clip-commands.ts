import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

const hasClip = ({ transport }: Editor): boolean => transport.clip !== undefined;

/** These act on the bound clip, or on the clip that Play would bind. */
export const clipCommands = [
  {
    id: 'play',
    label: 'Play or pause the clip',
    keys: [{ key: 'p' }],
    isOn: ({ session }) => session.playing.value,
    describe: ({ session }) => (session.playing.value ? 'Pause' : 'Play'),
    isEnabled: hasClip,
    run: ({ transport }) => transport.togglePlay(),
  },
  {
    id: 'play-here',
    label: 'Play or pause',
    keys: [{ key: ' ' }],
    keyOnly: true,
    context: 'timeline',
    isEnabled: hasClip,
    run: ({ transport }) => transport.togglePlay(),
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
    id: 'release-clip',
    label: 'Release the clip',
    isEnabled: ({ transport }) => transport.isBound,
    run: ({ transport }) => transport.release(),
  },
] as const satisfies readonly Command[];
