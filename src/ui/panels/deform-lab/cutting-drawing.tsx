import { cuttingSettings } from '../../deform-lab/cutting-settings.ts';
import {
  type Figure,
  figureSide,
  type FigureView,
  pathData,
  scaleBar,
  viewOfAll,
  viewOfJoint,
} from '../../deform-lab/figure-paths.ts';
import type { Editor } from '../../editor.ts';

interface CuttingDrawingProperties {
  readonly editor: Editor;
  readonly figure: Figure;
}

const zoomStep = 1.4;

/** The outlines as they lie in the plane, at one scale. A drag moves the drawing. */
export function CuttingDrawing({ editor: { session }, figure }: CuttingDrawingProperties) {
  const { view } = cuttingSettings(session);
  const shown = view.value ?? viewOfJoint(figure);
  const bar = scaleBar(shown);
  const zoom = (factor: number): void => {
    view.value = { ...shown, half: shown.half * factor };
  };
  const names = figure.outlines.map(({ label }) => label).join(', ');
  return (
    <figure>
      <svg
        class="cut"
        viewBox={`0 0 ${figureSide} ${figureSide}`}
        role="img"
        aria-label={`Outlines in the plane at ${figure.jointName}: ${names}`}
        onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={(event) => {
          if (event.buttons === 1) view.value = moved(event, shown);
        }}
      >
        {figure.outlines.map(({ role, lines }) => (
          <path key={role} class={role} d={pathData(lines, shown)} />
        ))}
        <path class="bar" d={`M10 282v8h${bar.pixels}v-8`} />
        <text x={16 + bar.pixels} y={291}>
          {bar.text}
        </text>
      </svg>
      <div class="row" role="group" aria-label="Part of the plane">
        <button type="button" onClick={() => (view.value = null)}>
          Joint
        </button>
        <button type="button" onClick={() => (view.value = viewOfAll(figure))}>
          All
        </button>
        <button type="button" aria-label="Nearer" onClick={() => zoom(1 / zoomStep)}>
          +
        </button>
        <button type="button" aria-label="Farther" onClick={() => zoom(zoomStep)}>
          −
        </button>
      </div>
      <ul>
        {figure.outlines.map(({ role, label, lines, isPending }) => (
          <li key={role}>
            <svg viewBox="0 0 36 8" aria-hidden="true">
              <path class={role} d="M2 4h32" />
            </svg>
            {label}
            {isPending && <span class="hint"> is being prepared</span>}
            {!isPending && lines.length === 0 && <span class="hint"> is not in this plane</span>}
          </li>
        ))}
      </ul>
    </figure>
  );
}

/** The view after the drawing moved with the pointer. */
function moved(event: PointerEvent, { center, half }: FigureView): FigureView {
  const scale = (2 * half) / (event.currentTarget as Element).getBoundingClientRect().width;
  const [right, rise] = center;
  return { half, center: [right - event.movementX * scale, rise + event.movementY * scale] };
}
