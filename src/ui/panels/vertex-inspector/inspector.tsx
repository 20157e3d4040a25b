import '../../styles/vertex-inspector.css';
import '../../styles/weights.css';
import { sizeOf } from '../../../evaluation/comparison/difference.ts';
import { differenceText } from '../../deform-lab/difference-text.ts';
import type { Editor } from '../../editor.ts';
import { inspectedOf } from '../../vertex-inspector/inspected.ts';
import { editedVertex } from '../../vertex-inspector/vertex-weights.ts';
import { MethodSteps } from './method-steps.tsx';
import { VertexNumber } from './vertex-number.tsx';
import { WeightRow } from './weight-row.tsx';

/** Explains how the skinning method brings one vertex to its place, and edits its weights. */
export function Inspector({ editor }: { readonly editor: Editor }) {
  const inspected = inspectedOf(editor);
  const vertex = editedVertex(editor);
  if (!inspected || !vertex) return <p class="hint">Select a character with a mesh.</p>;
  const { methods } = inspected;
  const [first] = methods;
  const size = sizeOf(vertex.actor.character);
  const way = distance(first.rest, first.place);
  return (
    <>
      <VertexNumber editor={editor} vertex={vertex} />
      <p class="hint">
        Click the skin for another vertex. This one is {differenceText(way, size)} from its place at
        rest. Colors are those of joints in the view.
      </p>
      <WeightRow editor={editor} vertex={vertex} />
      {methods.map((method, index) => (
        <MethodSteps
          key={index}
          method={method}
          actor={vertex.actor}
          apart={
            index > 0
              ? `${differenceText(distance(first.place, method.place), size)} from where ${first.label} puts it.`
              : ''
          }
        />
      ))}
    </>
  );
}

function distance(a: readonly number[], b: readonly number[]): number {
  return Math.hypot(...a.map((value, axis) => value - b[axis]!));
}
