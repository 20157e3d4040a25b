import type { GUI } from 'lil-gui';
import type { Gesture } from '../../document/store.ts';
import { formatDegrees, parseTyped } from '../angle-text.ts';
import { addSliderRole, type SliderRole, sliderTarget } from './slider-role.ts';

/** A number shown as a slider with a field; what is typed may go past the slider's range. */
export interface ValueRowOptions {
  readonly name: string;
  /** For screen readers: "Right elbow X". */
  readonly fullName: string;
  readonly minimum: number;
  readonly maximum: number;
  readonly isAngle: boolean;
  /** Its limits leave it one value: it is shown, and can't be changed. */
  readonly locked: boolean;
  /** What typing may reach. */
  readonly legal: readonly [number, number];
  read(): number;
  /** Begins one step of undo; the row previews values in it. */
  begin(): Gesture;
  preview(gesture: Gesture, value: number): void;
  reset(): void;
}

export interface ValueRow {
  /** Shows the value as it is now. */
  refresh(): void;
  show(visible: boolean): void;
}

/**
 * Adds a lil-gui row. lil-gui clamps what is typed to the slider, so the field's own events are taken
 * over here: typed numbers reach all legal values, in radians or, with °, degrees; arrow keys step.
 */
export function addValueRow(folder: GUI, options: ValueRowOptions): ValueRow {
  let gesture: Gesture | null = null;
  /** Whether keys, not the pointer, are at work on the slider. */
  let keyed = false;
  /** What the last press of the pointer did, which a second one right after it takes back. */
  let pressed: Gesture | null = null;
  const write = (value: number): void => {
    if (!gesture?.isOpen) gesture = options.begin();
    options.preview(gesture, value);
  };
  const finish = (): void => {
    gesture?.commit();
    if (gesture) pressed = gesture;
    gesture = null;
    keyed = false;
  };
  const bound = {
    get value(): number {
      return options.read();
    },
    set value(value: number) {
      // A drag that was canceled, or ended by an undo, does nothing more until it is let go.
      if (gesture && !gesture.isOpen) return;
      write(value);
    },
  };
  // A range without width has no slider; a locked row gets one that nothing moves.
  const minimum = options.locked ? options.minimum - 1 : options.minimum;
  const maximum = options.locked ? options.maximum + 1 : options.maximum;
  const controller = folder.add(bound, 'value', minimum, maximum).name(options.name).decimals(3);
  controller.onFinishChange(finish);

  const row = controller.domElement;
  const field = row.querySelector('input')!;
  const slider = row.querySelector<HTMLElement>('.lil-slider')!;
  const degrees = document.createElement('span');
  degrees.className = 'degrees';
  if (options.isAngle) row.querySelector('.lil-widget')!.append(degrees);
  field.setAttribute('aria-label', options.fullName);
  field.removeAttribute('aria-labelledby');
  const role: SliderRole = {
    name: options.fullName,
    minimum,
    maximum,
    value: () => options.read(),
    text: () => (options.isAngle ? formatDegrees(options.read()) : options.read().toFixed(3)),
  };
  const refreshRole = addSliderRole(row, role);

  const setTyped = (value: number): void => {
    if (!Number.isFinite(value)) return;
    const [least, most] = options.legal;
    write(Math.min(most, Math.max(least, value)));
    refresh();
  };
  row.addEventListener(
    'input',
    (event) => {
      event.stopImmediatePropagation();
      setTyped(parseTyped(field.value));
    },
    true,
  );
  row.addEventListener('keydown', onKey, true);
  slider.addEventListener('keyup', () => {
    if (keyed) finish();
  });
  field.addEventListener('blur', finish);
  // The second press of a double click would begin another drag; it resets instead.
  row.addEventListener(
    'mousedown',
    (event) => {
      if (event.detail === 1) pressed = null;
      if (options.locked || event.detail !== 2 || event.target === field) return;
      event.stopImmediatePropagation();
      pressed?.withdraw();
      options.reset();
    },
    true,
  );
  if (options.locked) {
    controller.disable();
    slider.tabIndex = -1;
    slider.setAttribute('aria-disabled', 'true');
    row.classList.add('locked');
    row.title = `${options.fullName} is locked: its limits are equal`;
    slider.setAttribute('aria-description', row.title);
  }
  refresh();
  return { refresh, show: (visible) => void controller.show(visible) };

  /** Arrows step in the field too; Home, End and the rest are the slider's alone. */
  function onKey(event: KeyboardEvent): void {
    const inField = event.target === field;
    if (inField && event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
    const target = sliderTarget(event, role);
    if (target === undefined) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    keyed = !inField;
    setTyped(target);
    field.value = options.read().toFixed(3);
  }

  function refresh(): void {
    controller.updateDisplay();
    // lil-gui leaves a field that has the focus alone, though an undo may have changed its number.
    const typed = parseTyped(field.value);
    if (Number.isFinite(typed) && typed !== options.read()) {
      field.value = options.read().toFixed(3);
    }
    degrees.textContent = role.text();
    refreshRole();
  }
}
