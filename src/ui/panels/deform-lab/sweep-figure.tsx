import type { RefObject } from 'preact';
import { kernelById } from '../../../skinning/registry.ts';
import type { NamedSweep } from '../../deform-lab/sweep-lab.ts';
import { linesOf, plotOf, plotSize } from '../../deform-lab/sweep-plot.ts';

interface SweepFigureProperties {
  readonly sweep: NamedSweep;
  readonly quantity: 'volumes' | 'sections';
  readonly drawing: RefObject<SVGSVGElement | null>;
}

/** How far the names of two methods are apart. */
const legendGap = 51;

const titles = { volumes: 'Volume', sections: 'Cross-section' } as const;
const absences = {
  volumes: 'No part of the mesh is closed, so it has no volume.',
  sections: 'The joint is not inside the mesh, or has no bone, so there is no section.',
} as const;

/** What is left of volume or cross-section over the range, a line for each method. */
export function SweepFigure({ sweep, quantity, drawing }: SweepFigureProperties) {
  const { angles, curves, joint, axis } = sweep;
  const degrees = angles.map((angle) => (angle * 180) / Math.PI);
  const lines = curves.map((curve) => {
    return curve[quantity].map((part) => (part === null ? null : part * 100));
  });
  const values = lines.flat().filter((value) => value !== null);
  const title = titles[quantity];
  if (values.length === 0) return <p class="hint">{absences[quantity]}</p>;
  const plot = plotOf([degrees[0]!, degrees.at(-1)!], values);
  const { left, right, top, bottom } = plot.area;
  const lows = curves.map(({ method }, i) => {
    const least = Math.min(...lines[i]!.filter((value) => value !== null));
    return `${kernelById(method).short} at least ${least.toFixed(1)} %`;
  });
  return (
    <figure>
      <figcaption>{title}, in per cent of that at rest</figcaption>
      <svg
        ref={drawing}
        viewBox={`0 0 ${plotSize.width} ${plotSize.height}`}
        role="img"
        aria-label={`${title} while ${joint} turns about ${axis}: ${lows.join(', ')}`}
      >
        {plot.percents.map((percent) => (
          <g key={percent}>
            <path
              class={percent === 100 ? 'grid rest' : 'grid'}
              d={`M${left} ${plot.down(percent)}H${right}`}
            />
            <text x={left - 5} y={plot.down(percent) + 3.5} text-anchor="end">
              {percent} %
            </text>
          </g>
        ))}
        {plot.angles.map((angle) => (
          <g key={angle}>
            <path class="grid" d={`M${plot.across(angle)} ${bottom}v4`} />
            <text
              x={plot.across(angle)}
              y={bottom + 16}
              text-anchor={plot.across(angle) > right - 8 ? 'end' : 'middle'}
            >
              {angle}°
            </text>
          </g>
        ))}
        <path class="grid" d={`M${left} ${top}V${bottom}H${right}`} />
        <text x={(left + right) / 2} y={bottom + 30} text-anchor="middle">
          {joint}, angle about {axis}
        </text>
        {curves.map(({ method }, i) => (
          <g key={method} class={`method-${method}`}>
            <polyline points={`${left + i * legendGap},9 ${left + i * legendGap + 18},9`} />
            <text x={left + i * legendGap + 22} y={12.5}>
              {kernelById(method).short}
            </text>
            {linesOf(plot, degrees, lines[i]!).map((points) => (
              <polyline key={points} points={points} />
            ))}
          </g>
        ))}
      </svg>
    </figure>
  );
}
