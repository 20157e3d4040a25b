import { expect, type Page } from '@playwright/test';

/** What is wrong with the boxes of the controls, one line for each fault. */
interface Findings {
  readonly faults: readonly string[];
  /** The controls that are in sight. */
  readonly count: number;
}

/**
 * Expects that every visible control is inside the window or can be scrolled there, is not covered,
 * overlaps no other control, and is a large enough target. The edges of the panels may be narrower
 * for a mouse, where a circle of the wanted size around their middle meets no other control (the
 * exception for spacing in WCAG 2.5.8).
 *
 * @param smallest the least width and height of a target, in CSS pixels
 */
export async function expectGoodBoxes(page: Page, where: string, smallest: number): Promise<void> {
  // This waits two frames, until the layout has followed what was pressed.
  await page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
  );
  const { faults, count } = await page.evaluate(findFaults, smallest);
  expect(faults, where).toEqual([]);
  expect(count, where).toBeGreaterThan(8);
}

/** Runs in the page. */
function findFaults(smallest: number): Findings {
  interface Box {
    readonly left: number;
    readonly right: number;
    readonly top: number;
    readonly bottom: number;
  }
  interface Control {
    readonly element: Element;
    readonly name: string;
    readonly box: Box;
    /** The part that its panels do not scroll away. */
    readonly seen: Box;
    readonly scrolls: boolean;
    /** Whether a panel around it scrolls sideways, where it may be out of sight. */
    readonly scrollsAcross: boolean;
  }
  const intersection = (a: Box, b: Box): Box => ({
    left: Math.max(a.left, b.left),
    right: Math.min(a.right, b.right),
    top: Math.max(a.top, b.top),
    bottom: Math.min(a.bottom, b.bottom),
  });
  const faults: string[] = [];
  const window = { left: 0, top: 0, right: innerWidth, bottom: innerHeight };
  const kinds =
    'button, select, input, summary, [role=slider], [role=treeitem], [role=option], [tabindex="0"]:not(canvas, ul)';
  const modal = document.querySelector('dialog:modal');
  const controls = [...(modal ?? document).querySelectorAll(kinds)]
    .filter((each) => each.checkVisibility({ visibilityProperty: true, opacityProperty: true }))
    .map((element): Control => {
      // A press anywhere on its label switches a box.
      const target = element.closest('label') ?? element;
      const box = target.getBoundingClientRect();
      let seen = intersection(box, window);
      let [scrolls, scrollsAcross] = [false, false];
      for (let around = target.parentElement; around; around = around.parentElement) {
        const { overflowX, overflowY } = getComputedStyle(around);
        if (overflowX === 'visible' && overflowY === 'visible') continue;
        seen = intersection(seen, around.getBoundingClientRect());
        scrolls ||= around.scrollHeight > around.clientHeight && overflowY !== 'hidden';
        scrollsAcross ||= around.scrollWidth > around.clientWidth && overflowX !== 'hidden';
      }
      const text = `${element.getAttribute('aria-label') ?? ''} ${element.textContent}`.trim();
      return { element, name: `“${text.slice(0, 40)}”`, box, seen, scrolls, scrollsAcross };
    });
  const inSight = controls.filter(
    ({ seen }) => seen.right - seen.left > 1 && seen.bottom - seen.top > 1,
  );

  const isAlone = (element: Element, box: Box): boolean => {
    const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
    return inSight.every(({ element: other, seen }) => {
      const [right, down] = [
        Math.max(seen.left - x, 0, x - seen.right),
        Math.max(seen.top - y, 0, y - seen.bottom),
      ];
      return other === element || Math.hypot(right, down) >= smallest / 2;
    });
  };
  for (const { element, name, box, scrolls, scrollsAcross } of controls) {
    const [width, height] = [box.right - box.left, box.bottom - box.top];
    const isCut = box.left < -0.5 || box.right > innerWidth + 0.5;
    if (isCut && !scrollsAcross) faults.push(`${name} is cut at a side`);
    if (!scrolls && (box.top < -0.5 || box.bottom > innerHeight + 0.5)) {
      faults.push(`${name} is out of the window`);
    }
    const isSpaced = element.matches('.splitter') && isAlone(element, box);
    if ((width < smallest - 0.5 || height < smallest - 0.5) && !isSpaced) {
      faults.push(`${name} is ${width.toFixed(1)} × ${height.toFixed(1)}`);
    }
  }
  for (const [index, { element, name, box, seen }] of inSight.entries()) {
    const [x, y] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
    const isCenterSeen =
      x > seen.left + 1 && x < seen.right - 1 && y > seen.top + 1 && y < seen.bottom - 1;
    const hit = isCenterSeen ? document.elementFromPoint(x, y) : null;
    if (hit && !element.contains(hit) && !hit.contains(element)) {
      faults.push(`${name} is covered by ${hit.outerHTML.slice(0, 90)}`);
    }
    for (const other of inSight.slice(index + 1)) {
      if (element.contains(other.element) || other.element.contains(element)) continue;
      const shared = intersection(seen, other.seen);
      if (shared.right - shared.left > 0.5 && shared.bottom - shared.top > 0.5) {
        faults.push(`${name} overlaps ${other.name}`);
      }
    }
  }
  return { faults, count: inSight.length };
}
