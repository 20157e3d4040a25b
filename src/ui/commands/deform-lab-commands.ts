import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

/** Commands of the deformation lab. */
export const deformLabCommands = [
  {
    id: 'compare',
    label: 'Compare skinning methods where they differ most, or stop',
    short: 'Compare methods',
    keys: [{ key: 'x' }],
    isOn: isComparing,
    run: async (editor) => (await loadOpening()).toggleComparison(editor),
  },
  {
    id: 'deform-lab',
    label: 'Deformation lab: skinning methods compared with numbers',
    short: 'Deformation lab',
    isEnabled: ({ store, session }) => selectedActor(store, session) !== undefined,
    run: async (editor) => (await loadOpening()).openLab(editor),
  },
  {
    id: 'compare-one-more',
    label: 'Compare one method more',
    short: 'Add a method',
    isEnabled: (editor) => {
      const count = editor.session.comparison.value?.methods.length;
      return count !== undefined && count < 4;
    },
    run: async (editor) => (await loadChanges()).addMethod(editor),
  },
  {
    id: 'comparison-layout',
    label: 'Compared methods side by side, or under a wipe',
    short: 'Side by side',
    isOn: ({ session }) => session.comparison.value?.layout === 'side by side',
    isEnabled: isComparing,
    run: async (editor) => (await loadChanges()).toggleLayout(editor),
  },
  {
    id: 'difference-colors',
    label: 'Differences of compared methods in color',
    short: 'Differences in color',
    isOn: ({ session }) => session.comparison.value?.heatMap === true,
    isEnabled: isComparing,
    run: async (editor) => {
      (await loadChanges()).changeComparison(editor, (former) => ({
        ...former,
        heatMap: !former.heatMap,
      }));
    },
  },
  {
    id: 'compare-normalized',
    label: 'Compare with rows of weights that sum to 1',
    short: 'Rows that sum to 1',
    isOn: ({ session }) => session.comparison.value?.normalizeRows === true,
    isEnabled: isComparing,
    run: async (editor) => {
      (await loadChanges()).changeComparison(editor, (former) => ({
        ...former,
        normalizeRows: !former.normalizeRows,
      }));
    },
  },
  {
    id: 'go-to-difference',
    label: 'Go to where the compared methods differ most',
    short: 'Go to the largest',
    isEnabled: isComparing,
    run: async (editor) => (await loadOpening()).showWorst(editor),
  },
  {
    id: 'save-comparison',
    label: 'Save the differences of compared methods as CSV',
    short: 'Save the numbers',
    isEnabled: isComparing,
    run: (editor) => editor.saveComparison(),
  },
] as const satisfies readonly Command[];

function isComparing({ session }: Editor): boolean {
  return session.comparison.value !== null;
}

function loadOpening() {
  return loadPart(import('../deform-lab/open-comparison.ts'));
}

function loadChanges() {
  return loadPart(import('../deform-lab/change-comparison.ts'));
}
