import type { Progress } from '../../deform-lab/measurement.ts';

interface MeasuringProperties {
  readonly progress: Progress;
  readonly cancel: () => void;
}

/** How far a measurement is, with a button that ends it. */
export function Measuring({ progress: { text, part }, cancel }: MeasuringProperties) {
  return (
    <div class="measuring">
      <span>{text}</span>
      <progress aria-label={text} {...(part === null ? {} : { value: part, max: 1 })} />
      <button type="button" onClick={cancel}>
        Cancel
      </button>
    </div>
  );
}
