import { printable } from '../../../../core/diagnostics.ts';
import type { Extrapolation } from '../../../../core/motion/clip-parts.ts';
import { setExtrapolation } from '../../../../core/motion/edit/extrapolation.ts';
import { extrapolations } from '../../../curve-editor/continue-curves.ts';
import type { CurveModel } from '../../../curve-editor/curve-model.ts';
import type { ShownCurve } from '../../../curve-editor/shown-curves.ts';

const sides = { before: 'Before', after: 'After' } as const;

interface ExtrapolationsProperties {
  readonly model: CurveModel;
  readonly curve: ShownCurve;
}

/** How a curve goes on before its first key and after its last one. */
export function Extrapolations({ model, curve }: ExtrapolationsProperties) {
  return (
    <div class="extrapolations">
      {(['before', 'after'] as const).map((side) => (
        <label key={side}>
          {sides[side]}
          <select
            aria-label={`${sides[side]} the keys of ${printable(curve.name, 60)}`}
            disabled={model.locked.value.has(curve.key)}
            value={curve.channel[side]}
            onChange={({ currentTarget }) => {
              const rule = currentTarget.value as Extrapolation;
              model.edit(`Continue ${side} the keys: ${extrapolations[rule]}`, (clip) =>
                setExtrapolation(clip, curve.key, side, rule),
              );
            }}
          >
            {Object.entries(extrapolations).map(([rule, label]) => (
              <option key={rule} value={rule}>
                {label}
              </option>
            ))}
          </select>
        </label>
      ))}
    </div>
  );
}
