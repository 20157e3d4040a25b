import type { Page } from '@playwright/test';

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** What the pointer is over, by the view's label and cursor. */
export interface Over {
  readonly limb: string;
  readonly cursor: string;
}

/**
 * Moves the pointer over places of the view, row by row, and returns the first one that is over
 * what is wanted. Events from within the page are many times as fast as those of the mouse.
 */
export async function find(
  within: Page,
  from: Place,
  to: Place,
  step: number,
  wanted: Partial<Over>,
): Promise<Place> {
  const found = await within.evaluate(
    async ({ from, to, step, wanted }) => {
      const view = document.querySelector('canvas')!;
      for (let y = from.y; y <= to.y; y += step) {
        for (let x = from.x; x <= to.x; x += step) {
          const place = { clientX: x, clientY: y, pointerType: 'mouse' };
          view.dispatchEvent(new PointerEvent('pointermove', place));
          // Picking waits for a frame if the pointer moves more often.
          await new Promise((resolve) => requestAnimationFrame(resolve));
          await new Promise((resolve) => setTimeout(resolve));
          const text = document.querySelector('.lit-bone strong')?.textContent ?? '';
          const { cursor } = getComputedStyle(view);
          const isLimb = wanted.limb === undefined || text.split(' → ')[0] === wanted.limb;
          if (isLimb && (wanted.cursor === undefined || cursor === wanted.cursor)) return { x, y };
        }
      }
      return null;
    },
    { from, to, step, wanted },
  );
  if (!found) throw new Error(`nothing in the view is ${JSON.stringify(wanted)}`);
  return found;
}
