import { loadPart } from '../../core/failure.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Editor } from '../editor.ts';
import type { Command } from './command.ts';

/** Commands of the vertex inspector. */
export const vertexCommands = [
  {
    id: 'inspect-vertex',
    label: 'Vertex inspector: how the skinning method reaches a vertex',
    short: 'Vertex inspector',
    isOn: isInspecting,
    isEnabled: ({ store, session }) =>
      (selectedActor(store, session)?.character.mesh.pointCount ?? 0) > 0,
    run: async (editor) => {
      const part = await loadPart(import('../vertex-inspector/open-inspector.ts'));
      await part.toggleInspector(editor);
    },
  },
  {
    id: 'normalize-vertex',
    label: 'Normalize the weights of the inspected vertex',
    short: 'Normalize row',
    isEnabled: isInspecting,
    run: async (editor) => (await loadWeights()).normalizeVertex(editor),
  },
  {
    id: 'reset-vertex',
    label: 'Reset the weights of the inspected vertex to those of the file',
    short: 'Reset vertex',
    isEnabled: (editor) => isInspecting(editor) && hasOwnWeights(editor),
    run: async (editor) => (await loadWeights()).resetVertex(editor),
  },
  {
    id: 'reset-weights',
    label: 'Reset all weights to those of the file',
    short: 'Reset all',
    isEnabled: hasOwnWeights,
    run: async (editor) => (await loadWeights()).resetVertices(editor),
  },
] as const satisfies readonly Command[];

function isInspecting({ session }: Editor): boolean {
  return session.inspectedPoint.value !== null;
}

function hasOwnWeights({ store, session }: Editor): boolean {
  return (selectedActor(store, session)?.skin ?? null) !== null;
}

function loadWeights() {
  return loadPart(import('../vertex-inspector/vertex-weights.ts'));
}
