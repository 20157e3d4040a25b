import { useRef } from 'preact/hooks';
import { defaultLimits } from '../../../core/limits.ts';
import type { Gesture } from '../../../document/store.ts';
import type { Looking } from '../../editor.ts';
import { type EditedVertex, setRow } from '../../vertex-inspector/vertex-weights.ts';

interface WeightFieldProperties {
  readonly editor: Looking;
  readonly vertex: EditedVertex;
  /** Of the influence. */
  readonly index: number;
  readonly name: string;
}

/**
 * A weight as a slider from 0 to 1, with a field beside it for any other number. A drag, a held
 * key, and what is typed until the field is left, are one step of undo each.
 */
export function WeightField({ editor, vertex, index, name }: WeightFieldProperties) {
  const open = useRef<Gesture | null>(null);
  const isKeyDown = useRef(false);
  const { row, point } = vertex;
  const { weight } = row[index]!;
  const label = `Weight of ${name} at vertex ${point}`;
  const change = (value: number): void => {
    if (!Number.isFinite(value) || Math.abs(value) > defaultLimits.weight) return;
    if (!open.current?.isOpen) open.current = editor.store.begin(label);
    const changed = row.map((each, i) => (i === index ? { ...each, weight: value } : each));
    setRow(editor, vertex, changed, label, open.current);
  };
  const commit = (): void => {
    open.current?.commit();
    open.current = null;
  };
  const end = (): void => {
    isKeyDown.current = false;
    commit();
  };
  const common = {
    onInput: ({ currentTarget }: { readonly currentTarget: HTMLInputElement }) =>
      change(currentTarget.valueAsNumber),
    // A key that is held changes it many times until it is released.
    onChange: () => !isKeyDown.current && commit(),
    onKeyDown: () => (isKeyDown.current = true),
    onKeyUp: end,
    onBlur: end,
  };
  const shown = Number(weight.toFixed(4));
  return (
    <>
      <input
        type="range"
        min="0"
        max="1"
        step="0.005"
        aria-label={label}
        value={weight}
        {...common}
      />
      <input
        type="number"
        step="0.01"
        aria-label={`${label}, as a number`}
        value={shown}
        {...common}
      />
    </>
  );
}
