import type { PageState } from './editor.ts';

/** The limits of a sheet's height, as parts of the window's. A lower sheet closes. */
const [least, most] = [0.18, 0.6];
const first = 0.46;
const keyStep = 0.06;

/**
 * Makes the handle of the sheets that a phone shows in place of panels. Dragging it, or arrow keys,
 * change the sheet's height; a sheet that is dragged to the bottom closes.
 *
 * @param root gets the height as the custom property `--sheet-height`
 */
export function addSheetHandle(root: HTMLElement, { drawer }: Pick<PageState, 'drawer'>): void {
  const handle = document.createElement('div');
  handle.className = 'sheet-handle';
  handle.tabIndex = 0;
  handle.setAttribute('role', 'separator');
  handle.setAttribute('aria-orientation', 'horizontal');
  handle.setAttribute('aria-label', 'Height of the sheet');
  handle.setAttribute('aria-valuemin', '0');
  handle.setAttribute('aria-valuemax', String(Math.round(most * 100)));
  const place = document.createElement('section');
  place.className = 'sheet-top';
  place.setAttribute('aria-label', 'Sheet');
  place.append(handle);
  root.querySelector('nav.phone')!.before(place);
  let part = first;

  const show = (wanted: number): void => {
    part = Math.min(most, Math.max(0, wanted));
    root.style.setProperty('--sheet-height', `${(part * 100).toFixed(1)}dvh`);
    handle.setAttribute('aria-valuenow', String(Math.round(part * 100)));
  };
  const finish = (): void => {
    if (part >= least) return;
    drawer.value = null;
    show(first);
  };
  show(first);

  handle.addEventListener('pointerdown', (event) => {
    handle.setPointerCapture(event.pointerId);
    const begin = part + event.clientY / innerHeight;
    const move = ({ clientY }: PointerEvent): void => show(begin - clientY / innerHeight);
    handle.addEventListener('pointermove', move);
    const end = (): void => {
      handle.removeEventListener('pointermove', move);
      finish();
    };
    handle.addEventListener('lostpointercapture', end, { once: true });
  });
  handle.addEventListener('keydown', (event) => {
    const step = { ArrowUp: keyStep, ArrowDown: -keyStep }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    show(part + step);
    finish();
  });
}
