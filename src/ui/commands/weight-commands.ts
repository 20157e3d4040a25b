import { truncationOf } from '../../evaluation/truncation.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import { focusVertexField } from '../focus-vertex-field.ts';
import { goToPoint, toggleWeights } from '../weights.ts';
import type { Command } from './command.ts';

/** Commands for the weights of the selected character. */
export const weightCommands = [
  {
    id: 'weights',
    label: 'Show the weights in color',
    short: 'Weights',
    keys: [{ key: 'v' }],
    isOn: ({ session }) => session.showWeights.value,
    isEnabled: (editor) => hasMesh(editor),
    run: (editor) => toggleWeights(editor),
  },
  {
    id: 'mark-vertex',
    label: 'Mark a vertex by its number',
    isEnabled: (editor) => hasMesh(editor),
    run: focusVertexField,
  },
  {
    id: 'worst-vertex',
    label: 'Look at the vertex that keeping few influences moves most',
    short: 'Go to the worst vertex',
    isEnabled: ({ store, session }) => (selectedActor(store, session)?.influences ?? null) !== null,
    run(editor) {
      const point = worstPoint(editor);
      if (point !== null) goToPoint(editor, point);
    },
  },
] as const satisfies readonly Command[];

function hasMesh({ store, session }: Editor): boolean {
  return (selectedActor(store, session)?.character.mesh.pointCount ?? 0) > 0;
}

function worstPoint({ evaluations }: Editor): number | null {
  const shown = evaluations.selected();
  const found = shown && truncationOf(shown);
  return found && found.movedCount > 0 ? found.worst : null;
}
