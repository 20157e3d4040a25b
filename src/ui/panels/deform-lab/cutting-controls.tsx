import type { Signal } from '@preact/signals-core';
import { batch } from '@preact/signals-core';
import type { PlaneDirection } from '../../../evaluation/comparison/cutting-plane.ts';
import { methods } from '../../../skinning/registry.ts';
import { cuttingSettings } from '../../deform-lab/cutting-settings.ts';
import type { Editor } from '../../editor.ts';

const directions: readonly { readonly id: PlaneDirection; readonly label: string }[] = [
  { id: 'along', label: 'Along the bend' },
  { id: 'across', label: 'Across the bone' },
  { id: 'camera', label: 'Facing the camera' },
];

const degree = Math.PI / 180;
const thirds = methods.filter(({ id }) => id !== 'rigid' && id !== 'linear-blend');

/** Where the plane is, and which method stands beside rigid parts and linear blend. */
export function CuttingControls({ editor }: { readonly editor: Editor }) {
  const { direction, turn, offset, third, view } = cuttingSettings(editor.session);
  const lie = (id: PlaneDirection): void => {
    batch(() => {
      direction.value = id;
      turn.value = 0;
      offset.value = 0;
      view.value = null;
    });
  };
  return (
    <div class="plane">
      <div class="row" role="group" aria-label="Plane">
        {directions.map(({ id, label }) => (
          <button
            key={id}
            type="button"
            aria-pressed={direction.value === id}
            onClick={() => lie(id)}
          >
            {label}
          </button>
        ))}
      </div>
      <Slide label="Move" unit="%" factor={0.01} most={100} value={offset} />
      <Slide label="Turn" unit="°" factor={degree} most={90} value={turn} />
      <label>
        <span>Third method</span>
        <select
          value={third.value}
          onChange={({ currentTarget }) => {
            third.value = thirds[currentTarget.selectedIndex]!.id;
          }}
        >
          {thirds.map(({ id, label }) => (
            <option key={id} value={id}>
              {label}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

interface SlideProperties {
  readonly label: string;
  readonly unit: string;
  /** What one step of the slider is in the value's own unit. */
  readonly factor: number;
  readonly most: number;
  readonly value: Signal<number>;
}

function Slide({ label, unit, factor, most, value }: SlideProperties) {
  const shown = Math.round(value.value / factor);
  return (
    <label>
      <span>{label}</span>
      <input
        type="range"
        min={-most}
        max={most}
        value={shown}
        aria-valuetext={`${shown} ${unit}`}
        onInput={({ currentTarget }) => {
          value.value = currentTarget.valueAsNumber * factor;
        }}
      />
      <output>
        {shown} {unit}
      </output>
    </label>
  );
}
