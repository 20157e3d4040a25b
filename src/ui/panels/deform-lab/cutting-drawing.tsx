import { cuttingSettings } from '../../deform-lab/cutting-settings.ts';
import {
  type Figure,
  figureSide,
  type FigureView,
  panned,
  pathData,
  scaleBar,
  viewOfAll,
  viewOfJoint,
  zoomedAt,
} from '../../deform-lab/figure-paths.ts';
import type { Editor } from '../../editor.ts';

interface CuttingDrawingProperties {
  readonly editor: Editor;
  readonly figure: Figure;
}

const zoomStep = 1.4;
/** How much a turn of the wheel by one pixel zooms. */
const zoomByPixel = 0.0015;
/** How far an arrow key moves the drawing, as a part of its side. */
const panStep = 0.1;
const middle = [0.5, 0.5] as const;

/** What keys do to the view. */
const keys: Readonly<Record<string, (view: FigureView) => FigureView | null>> = {
  ArrowLeft: (view) => panned(view, [panStep, 0]),
  ArrowRight: (view) => panned(view, [-panStep, 0]),
  ArrowUp: (view) => panned(view, [0, panStep]),
  ArrowDown: (view) => panned(view, [0, -panStep]),
  '+': (view) => zoomedAt(view, 1 / zoomStep, middle),
  '=': (view) => zoomedAt(view, 1 / zoomStep, middle),
  '-': (view) => zoomedAt(view, zoomStep, middle),
  Home: () => null,
};

/**
 * The outlines as they lie in the plane, at one scale. A drag or the arrow keys move the drawing; + and
 * - zoom, and so does the wheel with Ctrl or once the drawing has the focus, so that a wheel that
 * scrolls the panel is not caught on its way.
 */
export function CuttingDrawing({ editor: { session }, figure }: CuttingDrawingProperties) {
  const { view } = cuttingSettings(session);
  const shown = view.value ?? viewOfJoint(figure);
  const bar = scaleBar(shown);
  const zoom = (factor: number): void => {
    view.value = zoomedAt(shown, factor, middle);
  };
  const onWheel = (event: WheelEvent): void => {
    const element = event.currentTarget as Element;
    if (!event.ctrlKey && !event.metaKey && document.activeElement !== element) return;
    event.preventDefault();
    const { left, top, width, height } = element.getBoundingClientRect();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const at = [(event.clientX - left) / width, (event.clientY - top) / height] as const;
    view.value = zoomedAt(shown, Math.exp(event.deltaY * lines * zoomByPixel), at);
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    view.value = act(shown);
  };
  const names = figure.outlines.map(({ label }) => label).join(', ');
  return (
    <figure>
      <svg
        class="cut"
        viewBox={`0 0 ${figureSide} ${figureSide}`}
        role="img"
        tabindex={0} // as SVG has it
        onWheel={onWheel}
        onKeyDown={onKeyDown}
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
      <p class="hint">
        A drag or the arrow keys move the drawing; Ctrl and the wheel, or + and −, zoom.
      </p>
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
function moved(event: PointerEvent, view: FigureView): FigureView {
  const { width, height } = (event.currentTarget as Element).getBoundingClientRect();
  return panned(view, [event.movementX / width, event.movementY / height]);
}
