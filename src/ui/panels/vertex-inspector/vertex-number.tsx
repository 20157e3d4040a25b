import type { Editor } from '../../editor.ts';
import type { EditedVertex } from '../../vertex-inspector/vertex-weights.ts';

interface VertexNumberProperties {
  readonly editor: Editor;
  readonly vertex: EditedVertex;
}

/** The number of the inspected vertex, which can be typed. */
export function VertexNumber({ editor: { session }, vertex }: VertexNumberProperties) {
  const { pointCount } = vertex.actor.character.mesh;
  const choose = (input: HTMLInputElement): void => {
    const point = input.valueAsNumber;
    if (Number.isInteger(point) && point >= 0 && point < pointCount) {
      session.inspectedPoint.value = point;
    }
  };
  return (
    <label class="vertex">
      Vertex
      <input
        type="number"
        min="0"
        max={pointCount - 1}
        step="1"
        value={vertex.point}
        onInput={({ currentTarget }) => choose(currentTarget)}
        onBlur={({ currentTarget }) => (currentTarget.value = String(session.inspectedPoint.value))}
      />
      of {pointCount}, from 0
    </label>
  );
}
