import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { showsStressSheet } from '../deform-lab/measures-open.ts';
import { type Command, toggleDialog } from './command.ts';

/** The commands that explain skinning methods, and measure what they do. */
export const measureCommands = [
  {
    id: 'method-help',
    label: 'Skinning methods explained: formula, paper, and what each does badly',
    short: 'About the methods',
    run: (editor) => toggleDialog(editor, 'methods'),
  },
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
  {
    id: 'stress-suite',
    label: 'Stress suite: methods compared in the extremes of every joint, with pictures',
    short: 'Run the suite',
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.skeleton.jointCount ?? 0) > 0,
    run: async (editor) => {
      const part = await loadPart(import('../deform-lab/run-stress.ts'));
      await part.runStress(editor);
    },
  },
  {
    id: 'save-stress-table',
    label: 'Save the table of the stress suite as CSV',
    short: 'Save table (CSV)',
    isEnabled: () => showsStressSheet.value,
    run: async (editor) => {
      const part = await loadPart(import('../deform-lab/stress-lab.ts'));
      part.stressLabOf(editor).saveCsv();
    },
  },
  {
    id: 'save-stress-pictures',
    label: 'Save the pictures of the stress suite as one picture',
    short: 'Save pictures (PNG)',
    isEnabled: () => showsStressSheet.value,
    run: async (editor) => {
      const part = await loadPart(import('../deform-lab/save-stress-pictures.ts'));
      await part.saveStressPictures(editor);
    },
  },
] as const satisfies readonly Command[];
