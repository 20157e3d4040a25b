import type { Page } from '@playwright/test';

/** A control that the pointer can reach, and its middle in page coordinates. */
export interface FoundControl {
  readonly kind: 'click' | 'select' | 'type' | 'slide';
  readonly name: string;
  readonly x: number;
  readonly y: number;
  readonly width: number;
}

const controls =
  'button, select, summary, input, .lil-title, [role=treeitem], [role=slider], .timeline svg';

/**
 * Chooses one of the visible controls by the number and scrolls it into view. Returns null if
 * something else covers it.
 *
 * @param kind limits the choice to this kind
 */
export function findControl(
  page: Page,
  number: number,
  kind?: FoundControl['kind'],
): Promise<FoundControl | null> {
  return page.evaluate(
    ({ controls, number, wanted }) => {
      const kindOf = (element: Element): 'click' | 'select' | 'type' | 'slide' => {
        if (element instanceof HTMLSelectElement) return 'select';
        if (element.matches('[role=slider], [type=range], svg')) return 'slide';
        if (element.matches('input:not([type=checkbox])')) return 'type';
        return 'click';
      };
      const shown = [...document.querySelectorAll(controls)].filter(
        (element) =>
          element.checkVisibility({ visibilityProperty: true }) &&
          element.getBoundingClientRect().width > 0 &&
          !element.matches(':disabled') &&
          (wanted === undefined || kindOf(element) === wanted),
      );
      const element = shown[number % Math.max(shown.length, 1)];
      if (!element) return null;
      element.scrollIntoView({ block: 'nearest' });
      const { left, top, width, height } = element.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      const met = document.elementFromPoint(x, y);
      if (!met || !(element.contains(met) || met.contains(element))) return null;
      const title = element.getAttribute('aria-label') ?? element.textContent;
      const name = `${element.tagName.toLowerCase()} ${title.trim().slice(0, 40)}`;
      return { kind: kindOf(element), name, x, y, width };
    },
    { controls, number, wanted: kind },
  );
}
