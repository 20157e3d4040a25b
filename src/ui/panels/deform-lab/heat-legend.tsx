import { printable } from '../../../core/diagnostics.ts';
import { errorRamp, zeroColor } from '../../../skinning/weights/ramps.ts';
import { cssColor } from '../../css-color.ts';
import type { Compared, ComparedRow } from '../../deform-lab/compared.ts';
import { percentText } from '../../deform-lab/difference-text.ts';
import { heatScale } from '../../deform-lab/heat-scale.ts';
import { formatSize } from '../../number-text.ts';

interface HeatLegendProperties {
  readonly compared: Compared;
  readonly base: ComparedRow;
}

const stops = errorRamp.filter((_, index) => index % 16 === 0 || index === errorRamp.length - 1);
const gradient = `linear-gradient(to right, ${stops.map(cssColor).join(', ')})`;

/** What the colors of the heat map mean, in the character's units and in per cent of its height. */
export function HeatLegend({ compared, base }: HeatLegendProperties) {
  const scale = heatScale(compared);
  const ticks = [0, 0.5, 1].map((part) => part * scale);
  return (
    <section class="heat-legend" aria-label="Legend of the differences">
      <p>
        <span class="swatch" aria-hidden="true" style={{ background: cssColor(zeroColor) }} /> as{' '}
        {base.kernel.label}; units of {printable(base.evaluation.state.name, 40)}, and of its
        height:
      </p>
      <div class="scale" aria-hidden="true" style={{ background: gradient }} />
      <div class="ticks">
        {ticks.map((tick) => (
          <span key={tick}>
            {formatSize(tick)}
            <br />
            {percentText(tick, compared.size)}
          </span>
        ))}
      </div>
    </section>
  );
}
