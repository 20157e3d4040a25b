import { keepValue, keptValue } from './kept.ts';

/** The limits of a panel's width, in CSS pixels. */
const [least, most] = [180, 560];
const keyStep = 16;

interface Parts {
  /** Gets the width as the custom property `--kept-left` or `--kept-right`. */
  readonly root: HTMLElement;
  /** Holds the edges of the panels on both sides. */
  readonly view: HTMLElement;
  readonly left: HTMLElement;
  readonly right: HTMLElement;
}

/**
 * Lets the width of a panel be changed by dragging its inner edge, or by arrow keys while the edge
 * has the focus; a double click restores it. The width is kept for the next visit.
 */
export function addSplitter({ root, view, left, right }: Parts, side: 'left' | 'right'): void {
  const panel = side === 'left' ? left : right;
  const edge = document.createElement('div');
  edge.className = `splitter ${side}`;
  edge.tabIndex = 0;
  edge.setAttribute('role', 'separator');
  edge.setAttribute('aria-orientation', 'vertical');
  edge.setAttribute('aria-label', `Width of ${panel.getAttribute('aria-label') ?? side}`);
  edge.setAttribute('aria-valuemin', String(least));
  edge.setAttribute('aria-valuemax', String(most));
  view.append(edge);
  const key = `width of ${side}`;
  const toward = side === 'left' ? 1 : -1;

  const show = (width: number): void => {
    const shown = Math.min(most, Math.max(least, Math.round(width)));
    root.style.setProperty(`--kept-${side}`, `${shown}px`);
    edge.setAttribute('aria-valuenow', String(shown));
  };
  const restore = (): void => {
    root.style.removeProperty(`--kept-${side}`);
    edge.setAttribute('aria-valuenow', String(Math.round(panel.offsetWidth)));
  };
  const keep = (): void => {
    keepValue(key, root.style.getPropertyValue(`--kept-${side}`));
  };

  const kept = Number.parseFloat(keptValue(key));
  if (Number.isFinite(kept)) show(kept);
  else restore();

  edge.addEventListener('pointerdown', (event) => {
    edge.setPointerCapture(event.pointerId);
    const begin = panel.offsetWidth - toward * event.clientX;
    const move = ({ clientX }: PointerEvent): void => show(begin + toward * clientX);
    edge.addEventListener('pointermove', move);
    const end = (): void => {
      edge.removeEventListener('pointermove', move);
      keep();
    };
    edge.addEventListener('lostpointercapture', end, { once: true });
  });
  edge.addEventListener('dblclick', () => {
    restore();
    keep();
  });
  edge.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -keyStep, ArrowRight: keyStep }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    show(panel.offsetWidth + toward * step);
    keep();
  });
}
