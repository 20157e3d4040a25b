import { useMemo } from 'preact/hooks';
import type { ChartCurve } from '../../../posing/charts/chart-curve.ts';
import { isSingular } from '../../../posing/charts/chart.ts';
import type { Posing } from '../../editor.ts';
import { chartText, isStoredIn, numbersOf, storedTag } from '../../rotation-lab/chart-text.ts';
import { plotOf, plotSize } from '../../rotation-lab/plot.ts';
import type { RotationLab } from '../../rotation-lab/rotation-lab.ts';

interface ChartFigureProperties {
  readonly editor: Posing;
  readonly lab: RotationLab;
  readonly curve: ChartCurve;
}

/** A motion in a chart over the clip's time. A drag on it moves the playhead. */
export function ChartFigure({ editor, lab, curve }: ChartFigureProperties) {
  const subject = lab.subject.value!;
  const { clip, motion, curves } = subject;
  const { chart, singular, values } = curve;
  const plot = useMemo(() => plotOf(curve, [clip.start, clip.end]), [curve, clip]);
  const { left, right, top, bottom } = plot.area;
  const numbers = numbersOf(chart);
  const isStored = isStoredIn(chart.id, motion.stored);
  // While a clip plays only the playhead moves; an identical element is not rendered again.
  const drawn = useMemo(
    () => (
      <>
        {singular.map(([from, to]) => (
          <rect
            key={from}
            class="singular"
            x={plot.across(from)}
            y={top}
            width={Math.max(2, plot.across(to) - plot.across(from))}
            height={bottom - top}
          />
        ))}
        {plot.lines.map((line) => {
          const y = plot.down((line * Math.PI) / 180);
          return (
            <g key={line}>
              <path class={line === 0 ? 'grid zero' : 'grid'} d={`M${left} ${y}H${right}`} />
              <text x={left - 5} y={y + 3.5} text-anchor="end">
                {line}°
              </text>
            </g>
          );
        })}
        {numbers.map(({ index, look }) => (
          <polyline key={index} class={look} points={plot.points[index]} />
        ))}
        {motion.keys
          .filter((time) => time >= clip.start && time <= clip.end)
          .map((time) => (
            <path key={time} class="key" d={`M${plot.across(time)} ${bottom}v5`} />
          ))}
      </>
    ),
    [curve, plot, motion, clip],
  );
  const time = lab.time.value;
  const now = plot.across(Math.min(Math.max(time, clip.start), clip.end));
  const shown = lab.values.value[curves.indexOf(curve)];
  const fold = shown && isSingular(chart, shown) ? `${chart.foldText(shown)}.` : '';
  const seekAt = (event: MouseEvent): void => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * plotSize.width;
    const part = Math.min(Math.max((x - left) / (right - left), 0), 1);
    editor.transport.seek(clip.start + part * (clip.end - clip.start));
  };
  return (
    <figure>
      <figcaption>
        {chart.label}
        {isStored && <span class="stored">{storedTag(motion.stored)}</span>}
        <span class="names">
          {numbers.map(({ name, look }) => (
            <span key={name} class={look}>
              <svg class="sample" viewBox="0 0 18 8" aria-hidden="true">
                <path d="M1 4h16" />
              </svg>
              {name}
            </span>
          ))}
        </span>
      </figcaption>
      <svg
        class="chart"
        viewBox={`0 0 ${plotSize.width} ${plotSize.height}`}
        role="img"
        aria-label={chartText(subject, curve)}
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          seekAt(event);
        }}
        onPointerMove={(event) => event.buttons === 1 && seekAt(event)}
      >
        {drawn}
        <text x={left} y={bottom + 16}>
          {clip.start.toFixed(2)} s
        </text>
        <text x={right} y={bottom + 16} text-anchor="end">
          {clip.end.toFixed(2)} s
        </text>
        <path class="now" d={`M${now} ${top}V${bottom}`} />
        {shown &&
          numbers.map(({ index, look }) => (
            <circle key={index} class={look} cx={now} cy={plot.down(shown[index]!)} r={3} />
          ))}
      </svg>
      {singular.length > 0 && <p class={fold ? 'warning' : 'hint'}>{fold || restText(singular)}</p>}
      {values.length === 0 && <p class="hint">The clip has no length.</p>}
    </figure>
  );
}

/** Where the chart is shaded, while the playhead is elsewhere. */
function restText(singular: ChartCurve['singular']): string {
  const times = singular.map(([from, to]) => `${from.toFixed(2)} to ${to.toFixed(2)} s`);
  const shown = times.slice(0, 3).join(', ');
  return `Shaded where its numbers mean little: ${shown}${times.length > 3 ? ' and more' : ''}.`;
}
