/** The limits of a panel's width, in CSS pixels. */
const [least, most] = [180, 560];
const keyStep = 16;

/**
 * Lets the width of a panel be changed by dragging its inner edge, or by arrow keys while the edge
 * has the focus; a double click restores it. The width is kept for the next visit.
 *
 * @param root gets the width as the custom property `--kept-left` or `--kept-right`
 */
export function addSplitter(root: HTMLElement, panel: HTMLElement, side: 'left' | 'right'): void {
  const edge = document.createElement('div');
  edge.className = `splitter ${side}`;
  edge.tabIndex = 0;
  edge.setAttribute('role', 'separator');
  edge.setAttribute('aria-orientation', 'vertical');
  edge.setAttribute('aria-label', `Width of ${panel.getAttribute('aria-label') ?? side}`);
  edge.setAttribute('aria-valuemin', String(least));
  edge.setAttribute('aria-valuemax', String(most));
  root.append(edge);
  const key = `sinew ${side}`;
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

/** What an earlier visit kept; nothing where the browser keeps nothing. */
function keptValue(key: string): string {
  try {
    return localStorage.getItem(key) ?? '';
  } catch {
    return '';
  }
}

function keepValue(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // The width holds for this visit alone.
  }
}
