import type { Controller, GUI } from 'lil-gui';

/** The facts about a lil-gui slider that screen readers and keys need. */
export interface SliderRole {
  readonly name: string;
  readonly minimum: number;
  readonly maximum: number;
  value(): number;
  /** The value as text, such as "12.5°". */
  text(): string;
}

/** Gives a row's slider the ARIA role; the returned function updates its values. */
export function addSliderRole(row: HTMLElement, role: SliderRole): () => void {
  const slider = row.querySelector<HTMLElement>('.lil-slider')!;
  slider.tabIndex = 0;
  slider.setAttribute('role', 'slider');
  slider.setAttribute('aria-label', role.name);
  slider.setAttribute('aria-valuemin', role.minimum.toFixed(3));
  slider.setAttribute('aria-valuemax', role.maximum.toFixed(3));
  const refresh = (): void => {
    slider.setAttribute('aria-valuenow', role.value().toFixed(3));
    slider.setAttribute('aria-valuetext', role.text());
  };
  refresh();
  return refresh;
}

/**
 * Returns the value to which a key moves a slider: arrow keys move it by a 360th of the range, ten
 * times that with Shift or the page keys, Home and End to its ends. Other keys return undefined.
 */
export function sliderTarget(event: KeyboardEvent, role: SliderRole): number | undefined {
  if (event.ctrlKey || event.metaKey || event.altKey) return undefined;
  const step = ((role.maximum - role.minimum) / 360) * (event.shiftKey ? 10 : 1);
  const targets: Record<string, number> = {
    ArrowRight: role.value() + step,
    ArrowUp: role.value() + step,
    ArrowLeft: role.value() - step,
    ArrowDown: role.value() - step,
    PageUp: role.value() + 10 * step,
    PageDown: role.value() - 10 * step,
    Home: role.minimum,
    End: role.maximum,
  };
  return targets[event.key];
}

/** Adds the role and the keys, which lil-gui lacks, to every slider that does not have them yet. */
export function addSliderRoles(gui: GUI): void {
  for (const controller of gui.controllersRecursive()) {
    const slider = controller.domElement.querySelector('.lil-slider:not([role])');
    if (slider) makeAccessible(controller as NumberController);
  }
}

/** The fields of lil-gui's number controller that its types declare private. */
type NumberController = Controller & { _min: number; _max: number; _name: string };

function makeAccessible(controller: NumberController): void {
  const value = (): number => controller.getValue() as number;
  const role: SliderRole = {
    name: `${controller.parent._title} ${controller._name}`,
    minimum: controller._min,
    maximum: controller._max,
    value,
    text: () => value().toFixed(2),
  };
  const refresh = addSliderRole(controller.domElement, role);
  const update = controller.updateDisplay.bind(controller);
  controller.updateDisplay = () => {
    update();
    refresh();
    return controller;
  };
  controller.domElement.querySelector('.lil-slider')!.addEventListener('keydown', (event) => {
    const target = sliderTarget(event as KeyboardEvent, role);
    if (target === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    controller.setValue(Math.min(role.maximum, Math.max(role.minimum, target)));
  });
}
