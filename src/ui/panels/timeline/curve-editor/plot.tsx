import { effect, signal } from '@preact/signals-core';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { type CurveModel } from '../../../curve-editor/curve-model.ts';
import { hitAt, type Shown } from '../../../curve-editor/hits.ts';
import { insertOnCurve } from '../../../curve-editor/insert-on-curve.ts';
import { timeAt } from '../../../curve-editor/plot.ts';
import type { Box } from '../../../curve-editor/scale-box.ts';
import type { ValueUnit } from '../../../curve-editor/value-axis.ts';
import type { Editor } from '../../../editor.ts';
import { timeUnit } from '../../../timeline/timeline-state.ts';
import { onceAFrame } from '../../../once-a-frame.ts';
import { KeyMenu, openMenuOfKeys } from '../dope-sheet/key-menu.tsx';
import { drawPlot } from './draw-plot.ts';
import { readColors } from './plot-colors.ts';
import { listenToPlot } from './plot-pointer.ts';
import type { PlotView } from './plot-view.ts';
import { listenToWindow } from './plot-window.ts';

interface PlotProperties {
  readonly editor: Editor;
  readonly model: CurveModel;
  readonly label: string;
}

/** The curves, drawn on a canvas; by keyboard, the table of keys has all that is in it. */
export function Plot({ editor, model, label }: PlotProperties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const probe = useRef<HTMLSpanElement>(null);
  const menu = useRef<HTMLDivElement>(null);
  const size = useMemo(() => signal({ width: 1, height: 1 }), []);
  const chosenBox = useMemo(() => signal<Box | null>(null), []);
  const shown = (): Shown => shownOf(model, size.value);

  useEffect(() => {
    const element = canvas.current!;
    const openMenu = (x: number, y: number, isHeld: boolean): void =>
      openMenuOfKeys(menu.current!, x, y, isHeld);
    const view: PlotView = { canvas: element, editor, model, shown, chosenBox, openMenu };
    const observer = new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect;
      size.value = { width: Math.max(1, width), height: Math.max(1, height) };
    });
    observer.observe(element);
    listenToWindow(view);
    const endPointer = listenToPlot(view);
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const scheme = signal(0);
    const onScheme = (): void => {
      scheme.value++;
    };
    dark.addEventListener('change', onScheme);
    // The panel may be gone by the next frame.
    const draw = onceAFrame<readonly unknown[]>(() => {
      if (probe.current) paint(element, probe.current, view);
    });
    // What is drawn is read here, so that a change of it draws again.
    const endDrawing = effect(() => {
      draw([
        ...[shown(), chosenBox.value, model.shown.value],
        ...[timeUnit.value, editor.theme.value, scheme.value],
      ]);
    });
    return () => {
      endPointer();
      endDrawing();
      dark.removeEventListener('change', onScheme);
      observer.disconnect();
    };
  }, [editor, model]);

  return (
    <div
      class="plot"
      tabIndex={-1}
      onKeyDown={(event) => {
        if (event.key !== 'Escape' || !model.fieldsAt.peek()) return;
        event.stopPropagation();
        model.fieldsAt.value = null;
      }}
    >
      <span ref={probe} hidden />
      <canvas
        ref={canvas}
        role="img"
        aria-label={label}
        onPointerDown={({ currentTarget }) => currentTarget.parentElement!.focus()}
        onDblClick={({ offsetX, offsetY }) => {
          const place = { x: offsetX, y: offsetY };
          const seen = shown();
          const hit = hitAt(seen, place, 8);
          if (hit.of === 'line') insertOnCurve(editor, hit.line.key, timeAt(seen.plot, place.x));
        }}
      />
      <p class="telling" aria-hidden="true">
        {model.telling.value}
      </p>
      <KeyMenu editor={editor} element={menu} />
    </div>
  );
}

function shownOf(
  model: CurveModel,
  { width, height }: { readonly width: number; readonly height: number },
): Shown {
  const plot = {
    time: model.timeWindow.value,
    values: model.valueWindow.value,
    width,
    height,
  };
  return {
    lines: model.lines.value,
    locked: model.locked.value,
    selection: model.selection.value,
    plot,
  };
}

function paint(
  canvas: HTMLCanvasElement,
  probe: HTMLElement,
  { shown, model, chosenBox }: PlotView,
): void {
  const context = canvas.getContext('2d');
  const seen = shown();
  const { width, height } = seen.plot;
  const ratio = devicePixelRatio;
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  if (!context) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const { fps = 30, start = 0, end = 1 } = model.shown.peek()?.parts ?? {};
  drawPlot(context, {
    ...seen,
    colors: readColors(probe),
    fps,
    timeUnit: timeUnit.peek(),
    range: [start, end],
    units: unitsOf(model),
    chosenBox: chosenBox.peek(),
  });
}

/** What the axis at the left is marked in, and the one at the right if curves need another. */
function unitsOf(model: CurveModel): readonly [ValueUnit, ValueUnit | null] {
  if (model.isNormalized.peek()) return ['number', null];
  const hidden = model.hidden.peek();
  const units = new Set(
    model.curves.peek().flatMap(({ key, unit }) => (hidden.has(key) ? [] : unit)),
  );
  if (!units.has('angle')) return ['number', null];
  return ['angle', units.size > 1 ? 'number' : null];
}
