import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';
import { keepValue, keptValue } from '../../kept.ts';

/** The limits of the rows' height, in CSS pixels, and what an arrow key adds. */
const [least, most] = [72, 720];
const keyStep = 20;
/** The height until it is changed, as the style sheet has it. */
const usual = 192;
const keptAs = 'height of timeline';

interface HeightEdgeProperties {
  /** Gets the height as the custom property `--kept-height`. */
  readonly timeline: RefObject<HTMLElement | null>;
}

/**
 * The upper edge of the timeline, by which it is made higher: by a drag, or by arrow keys; a double
 * click restores it. The height is kept for the next visit.
 */
export function HeightEdge({ timeline }: HeightEdgeProperties) {
  const show = (height: number): void => {
    const shown = Math.min(most, Math.max(least, Math.round(height)));
    timeline.current!.style.setProperty('--kept-height', `${shown}px`);
  };
  const present = (): number =>
    timeline.current!.querySelector<HTMLElement>('.keys-sheet')!.offsetHeight;
  const keep = (): void =>
    keepValue(keptAs, timeline.current!.style.getPropertyValue('--kept-height'));
  useLayoutEffect(() => {
    const kept = Number.parseFloat(keptValue(keptAs));
    if (Number.isFinite(kept)) show(kept);
  }, []);
  return (
    <div
      class="splitter height-edge"
      role="separator"
      tabIndex={0}
      aria-orientation="horizontal"
      aria-label="Height of the timeline"
      aria-valuemin={least}
      aria-valuemax={most}
      aria-valuenow={Number.parseFloat(keptValue(keptAs)) || usual}
      onPointerDown={(event) => {
        const edge = event.currentTarget;
        edge.setPointerCapture(event.pointerId);
        const from = present() + event.clientY;
        const move = ({ clientY }: PointerEvent): void => show(from - clientY);
        edge.addEventListener('pointermove', move);
        const end = (): void => {
          edge.removeEventListener('pointermove', move);
          keep();
        };
        edge.addEventListener('lostpointercapture', end, { once: true });
      }}
      onDblClick={() => {
        timeline.current!.style.removeProperty('--kept-height');
        keep();
      }}
      onKeyDown={(event) => {
        const step = { ArrowUp: keyStep, ArrowDown: -keyStep }[event.key];
        if (step === undefined) return;
        event.preventDefault();
        show(present() + step);
        keep();
      }}
    />
  );
}
