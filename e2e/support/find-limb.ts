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
 * Moves the pointer over the places of a grid in the view, every second one of every second row
 * first, and returns the first that is over what is wanted. Events from within the page are many
 * times as fast as those of the mouse.
 */
export async function find(
  within: Page,
  from: Place,
  to: Place,
  step: number,
  wanted: Partial<Over>,
): Promise<Place> {
  const found = await within.evaluate(
    async ({ places, wanted }) => {
      const view = document.querySelector('canvas')!;
      for (const { x, y } of places) {
        const event = { clientX: x, clientY: y, pointerType: 'mouse' };
        view.dispatchEvent(new PointerEvent('pointermove', event));
        // Picking waits for a frame if the pointer moves more often.
        await new Promise((resolve) => requestAnimationFrame(resolve));
        await new Promise((resolve) => setTimeout(resolve));
        const text = document.querySelector('.lit-bone strong')?.textContent ?? '';
        const { cursor } = getComputedStyle(view);
        const isLimb = wanted.limb === undefined || text.split(' → ')[0] === wanted.limb;
        if (isLimb && (wanted.cursor === undefined || cursor === wanted.cursor)) return { x, y };
      }
      return null;
    },
    { places: coarseFirst(from, to, step), wanted },
  );
  if (!found) throw new Error(`nothing in the view is ${JSON.stringify(wanted)}`);
  return found;
}

/** The places of a grid, in four coarser grids. */
function coarseFirst(from: Place, to: Place, step: number): Place[] {
  const places: Place[] = [];
  for (const [right, down] of [
    [0, 0],
    [step, step],
    [step, 0],
    [0, step],
  ] as const) {
    for (let y = from.y + down; y <= to.y; y += 2 * step) {
      for (let x = from.x + right; x <= to.x; x += 2 * step) places.push({ x, y });
    }
  }
  return places;
}
