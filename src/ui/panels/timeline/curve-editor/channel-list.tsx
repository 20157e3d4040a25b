import { printable } from '../../../../core/diagnostics.ts';
import { type CurveModel, toggled } from '../../../curve-editor/curve-model.ts';
import type { ShownCurve } from '../../../curve-editor/shown-curves.ts';
import { Extrapolations } from './extrapolations.tsx';

interface ChannelListProperties {
  readonly model: CurveModel;
}

/** The channels of the plot: which are seen, which are locked, and how the chosen one goes on. */
export function ChannelList({ model }: ChannelListProperties) {
  const chosen = model.curve.value;
  return (
    <div class="channels">
      <ul aria-label="Curves">
        {model.curves.value.map((curve) => (
          <ChannelRow key={curve.key} model={model} curve={curve} isChosen={curve === chosen} />
        ))}
      </ul>
      {chosen && !model.showsTable.value && <Extrapolations model={model} curve={chosen} />}
    </div>
  );
}

interface RowProperties extends ChannelListProperties {
  readonly curve: ShownCurve;
}

function ChannelRow({ model, curve, isChosen }: RowProperties & { readonly isChosen: boolean }) {
  const { key, color, isDotted } = curve;
  const name = printable(curve.name, 60);
  const isSeen = !model.hidden.value.has(key);
  const isLocked = model.locked.value.has(key);
  return (
    <li class={isSeen ? '' : 'unseen'}>
      <button
        type="button"
        class="name"
        aria-pressed={isChosen}
        onClick={() => (model.chosen.value = key)}
      >
        <i class={`swatch plot-${color} ${isDotted ? 'dotted' : ''}`} />
        <span>{name}</span>
      </button>
      <button
        type="button"
        class="sign"
        aria-pressed={isSeen}
        aria-label={`Show ${name}`}
        title={isSeen ? 'Hide the curve' : 'Show the curve'}
        onClick={() => (model.hidden.value = toggled(model.hidden.value, key))}
      >
        {isSeen ? '●' : '○'}
      </button>
      <button
        type="button"
        class="sign"
        aria-pressed={isLocked}
        aria-label={`Lock ${name}`}
        title={isLocked ? 'Unlock the curve' : 'Lock the curve'}
        onClick={() => (model.locked.value = toggled(model.locked.value, key))}
      >
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <rect x="3.5" y="7.5" width="9" height="6" rx="1" />
          <path
            d={isLocked ? 'M5.5 7.5V5a2.5 2.5 0 0 1 5 0v2.5' : 'M5.5 7.5V4a2.5 2.5 0 0 1 5 0'}
          />
        </svg>
      </button>
    </li>
  );
}
