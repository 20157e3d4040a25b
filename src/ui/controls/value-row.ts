import type { GUI } from 'lil-gui';
import type { Gesture } from '../../document/store.ts';
import { formatDegrees, parseTyped } from '../angle-text.ts';
import { type KeyedState, keyedText } from '../keyed-state.ts';
import { addSliderRole, type SliderRole, sliderTarget } from './slider-role.ts';

/**
 * A number that is shown as a slider with a text field; a typed number may exceed the slider's
 * range.
 */
export interface ValueRowOptions {
  readonly name: string;
  /** For screen readers: "Right elbow X". */
  readonly fullName: string;
  readonly minimum: number;
  readonly maximum: number;
  readonly isAngle: boolean;
  /** The axis whose color it has, if any. */
  readonly axis?: 0 | 1 | 2;
  /** Whether its limits allow only one value, so that it is shown but can't be changed. */
  readonly locked: boolean;
  /** The range of numbers that can be typed. */
  readonly legal: readonly [number, number];
  read(): number;
  /** Begins one step of undo, in which the row previews values. */
  begin(): Gesture;
  preview(gesture: Gesture, value: number): void;
  reset(): void;
  /** What the bound clip has to do with the value, which a mark shows; nothing, if absent. */
  keyed?(): KeyedState;
}

export interface ValueRow {
  /** Updates the shown value. */
  refresh(): void;
  show(visible: boolean): void;
}

/**
 * Adds a lil-gui row. lil-gui clamps typed numbers to the slider's range, so this code handles the
 * events of the text field itself: typed numbers may be any legal value, in radians or, with °, in
 * degrees, and arrow keys step.
 */
export function addValueRow(folder: GUI, options: ValueRowOptions): ValueRow {
  let gesture: Gesture | null = null;
  /** Whether the slider is being moved by keys, not by the pointer. */
  let keyed = false;
  /** The gesture of the last pointer press; a second press right after it undoes that gesture. */
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
      // After a drag was canceled or ended by an undo, it has no effect until the button is
      // released.
      if (gesture && !gesture.isOpen) return;
      write(value);
    },
  };
  // lil-gui makes no slider for an empty range, so a locked row gets a range in which nothing
  // moves.
  const minimum = options.locked ? options.minimum - 1 : options.minimum;
  const maximum = options.locked ? options.maximum + 1 : options.maximum;
  const controller = folder.add(bound, 'value', minimum, maximum).name(options.name).decimals(3);
  controller.onFinishChange(finish);

  const row = controller.domElement;
  const field = row.querySelector('input')!;
  const slider = row.querySelector<HTMLElement>('.lil-slider')!;
  if (options.axis !== undefined) row.classList.add(`axis-${'xyz'[options.axis]!}`);
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
  // The second press of a double click must not begin another drag; it resets the value.
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

  /** Arrow keys also step in the text field; Home, End and the others apply only to the slider. */
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
    // lil-gui does not update a text field that has the focus, although undo may have changed its
    // number.
    const typed = parseTyped(field.value);
    if (Number.isFinite(typed) && typed !== options.read()) {
      field.value = options.read().toFixed(3);
    }
    degrees.textContent = role.text();
    refreshRole();
    if (!options.keyed || options.locked) return;
    const keyed = options.keyed();
    if (row.dataset['keyed'] === keyed) return;
    row.dataset['keyed'] = keyed;
    row.classList.toggle('unkeyed', keyed === 'unkeyed');
    slider.setAttribute('aria-description', keyedText[keyed]);
  }
}
