import type { Compared } from '../../deform-lab/compared.ts';
import { differenceText } from '../../deform-lab/difference-text.ts';
import { placeOfWorst, textIsLeft, viewPlace } from '../../deform-lab/place-of-worst.ts';
import type { Editor } from '../../editor.ts';
import { inspectPoint } from '../../vertex-inspector/open-inspector.ts';

interface WorstMarkProperties {
  readonly editor: Editor;
  readonly compared: Compared;
  /** The number of views that are side by side. */
  readonly columns: number;
}

/**
 * Marks where a method differs most from the base, in each view, with a line between the two places
 * and the figure, in the method's own view. A click inspects the vertex.
 */
export function WorstMark({ editor, compared, columns }: WorstMarkProperties) {
  const { session, viewer } = editor;
  const place = placeOfWorst(compared);
  if (!place) return null;
  const camera = viewer.viewCamera.value;
  const { worst, base, size } = compared;
  const text = differenceText(worst!.difference.largest, size);
  const { inspectedPoint } = session;
  const isOpen = inspectedPoint.value === place.point;
  const [from, to] = [place.base, place.other].map((each) => {
    const [x, y] = viewPlace(camera, viewer.aspect, each);
    return [x * 100, y * 100] as const;
  });
  if (to!.some((each) => each < 0 || each > 100)) return null;
  const isLeft = textIsLeft(to![0] / 100);
  return (
    <>
      {Array.from({ length: columns }, (_, column) => {
        const view = {
          left: `${(column / columns) * 100}%`,
          width: `${100 / columns}%`,
        };
        return (
          <div key={column} class="worst-mark" style={view}>
            <svg aria-hidden="true">
              <line x1={`${from![0]}%`} y1={`${from![1]}%`} x2={`${to![0]}%`} y2={`${to![1]}%`} />
              <circle cx={`${from![0]}%`} cy={`${from![1]}%`} r="3" />
              <circle cx={`${to![0]}%`} cy={`${to![1]}%`} r="8" class="ring" />
            </svg>
            {(columns === 1 || compared.rows[column]!.method === worst!.method) && (
              <button
                type="button"
                class={`${isLeft ? 'to-left' : ''} ${to![1] < from![1] ? 'above' : 'below'}`}
                style={{ '--x': `${to![0]}%`, top: `${to![1]}%` }}
                aria-pressed={isOpen}
                aria-label={`Largest difference of ${worst!.kernel.label} from ${base.kernel.label}: ${text}, vertex ${place.point}. Inspect it`}
                title={`Vertex #${place.point}: inspect it`}
                onClick={() => {
                  if (isOpen) inspectedPoint.value = null;
                  else inspectPoint(editor, place.point);
                }}
              >
                {text}
              </button>
            )}
          </div>
        );
      })}
    </>
  );
}
