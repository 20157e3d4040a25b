import { useEffect, useRef } from 'preact/hooks';
import type { Vector3 } from '../../../posing/ik/problem.ts';
import { type IkLab, possibleStarts, type Subject } from '../../ik-lab.ts';
import { targetKinds } from '../../ik-lab-text.ts';
import { axisNames } from '../../joint-values.ts';

interface TargetProperties {
  readonly lab: IkLab;
  readonly subject: Subject;
}

/** Which joints bring the selected one to which place. */
export function Target({ lab, subject }: TargetProperties) {
  const { chain, kind } = subject;
  const { names } = chain.skeleton;
  const note = targetKinds.find(({ id }) => id === kind)?.note;
  return (
    <fieldset>
      <legend>Target of {names[chain.path.at(-1)!]}</legend>
      <div class="kinds">
        {targetKinds.map(({ id, label }) => (
          <button key={id} type="button" aria-pressed={id === kind} onClick={() => lab.aimAt(id)}>
            {label}
          </button>
        ))}
      </div>
      {note && <p class="hint">{note}</p>}
      <Place lab={lab} subject={subject} />
      <label class="start">
        Chain from
        <select
          value={chain.path[0]}
          onChange={({ currentTarget }) =>
            lab.aimAt(kind ?? 'reachable', Number(currentTarget.value))
          }
        >
          {possibleStarts(chain).map((joint) => (
            <option key={joint} value={joint}>
              {names[joint]}
            </option>
          ))}
        </select>
      </label>
      {lab.natures.value.length > 0 && (
        <label class="natural">
          <input
            type="checkbox"
            checked={lab.isNatural.value}
            onChange={({ currentTarget }) => lab.setNatural(currentTarget.checked)}
          />
          Natural joints
        </label>
      )}
      {lab.isPoseNew.value && (
        <p class="hint">
          The methods start from an earlier pose.{' '}
          <button type="button" onClick={() => lab.startFromShown()}>
            Start from the shown one
          </button>
        </p>
      )}
    </fieldset>
  );
}

/** The place of the target, in the character's space. */
function Place({ lab, subject: { target, chain } }: TargetProperties) {
  const step = stepOf(chain.length);
  const change = (axis: number, value: number): void => {
    if (Number.isFinite(value))
      lab.moveTarget(target.map((old, i) => (i === axis ? value : old)) as unknown as Vector3);
  };
  return (
    <div class="place">
      {axisNames.map((name, axis) => (
        <PlaceField
          key={name}
          name={name}
          step={step}
          value={target[axis]!}
          onChange={(value) => change(axis, value)}
        />
      ))}
    </div>
  );
}

interface PlaceFieldProperties {
  readonly name: string;
  readonly step: number;
  readonly value: number;
  readonly onChange: (value: number) => void;
}

function PlaceField({ name, step, value, onChange }: PlaceFieldProperties) {
  const field = useRef<HTMLInputElement>(null);
  const text = String(Number(value.toPrecision(4)));
  // A field keeps what is being typed until it is another number.
  useEffect(() => {
    if (Number(field.current!.value) !== Number(text)) field.current!.value = text;
  }, [text]);
  return (
    <label class={`axis-${name.toLowerCase()}`}>
      {name}
      <input
        ref={field}
        type="number"
        step={step}
        aria-label={`Target ${name}`}
        defaultValue={text}
        onInput={({ currentTarget }) => onChange(currentTarget.valueAsNumber)}
      />
    </label>
  );
}

/** A hundredth of a length, rounded to a power of ten or half of one. */
function stepOf(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length / 50));
  return length / 50 >= 5 * power ? 5 * power : power;
}
