import { useId } from 'preact/hooks';

interface SelectRowProperties {
  readonly label: string;
  readonly value: string;
  /** The texts of the options by their values. */
  readonly options: Readonly<Record<string, string>>;
  readonly onChange: (value: string) => void;
}

export function SelectRow({ label, value, options, onChange }: SelectRowProperties) {
  return (
    <label>
      <span>{label}</span>
      <select value={value} onChange={({ currentTarget }) => onChange(currentTarget.value)}>
        {Object.entries(options).map(([id, text]) => (
          <option key={id} value={id}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}

interface NumberRowProperties {
  readonly label: string;
  readonly unit: string;
  readonly value: number;
  readonly min: number;
  readonly max: number;
  readonly step: number | 'any';
  /** Numbers that are offered. */
  readonly usual?: readonly number[];
  /** Is called with numbers within the limits alone. */
  readonly onChange: (value: number) => void;
}

export function NumberRow({ label, unit, value, usual, onChange, ...limits }: NumberRowProperties) {
  const list = useId();
  return (
    <label>
      <span>{label}</span>
      <span class="amount">
        <input
          type="number"
          required
          {...limits}
          value={value}
          list={usual && list}
          onInput={({ currentTarget }) => {
            if (currentTarget.validity.valid) onChange(currentTarget.valueAsNumber);
          }}
        />{' '}
        {unit}
        {usual && (
          <datalist id={list}>
            {usual.map((each) => (
              <option key={each} value={each} />
            ))}
          </datalist>
        )}
      </span>
    </label>
  );
}

interface TickRowProperties {
  readonly label: string;
  readonly isOn: boolean;
  readonly isEnabled?: boolean;
  readonly onChange: (isOn: boolean) => void;
}

export function TickRow({ label, isOn, isEnabled = true, onChange }: TickRowProperties) {
  return (
    <label class="tick">
      <input
        type="checkbox"
        checked={isOn}
        disabled={!isEnabled}
        onChange={({ currentTarget }) => onChange(currentTarget.checked)}
      />
      <span>{label}</span>
    </label>
  );
}
