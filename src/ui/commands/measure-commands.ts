import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Command } from './command.ts';

/** The commands that measure what skinning methods do. */
export const measureCommands = [
  {
    id: 'sweep',
    label: 'Sweep: volume and cross-section over the range of a joint, by each method',
    short: 'Sweep',
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0,
    run: async (editor) => {
      const part = await loadPart(import('../deform-lab/toggle-measures.ts'));
      await part.toggleMeasures(editor, 'sweep');
    },
  },
] as const satisfies readonly Command[];
