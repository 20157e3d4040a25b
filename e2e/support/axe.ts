import AxeBuilder from '@axe-core/playwright';
import { expect, type Page } from '@playwright/test';

interface Checked {
  /** The part of the page that is checked, as a selector; the whole page if absent. */
  readonly within?: string;
  /** The rules that are checked; all of them if absent. */
  readonly rules?: readonly string[];
}

/** In the dark theme, only the colors differ. */
export const onlyColors = { rules: ['color-contrast'] } as const;

/**
 * What a checker can detect of WCAG 2.2 AA on the page as it is: names, roles, contrast and the order
 * of headings. It takes a second for a whole page, and less for a part.
 */
export async function violations(page: Page, { within, rules }: Checked = {}): Promise<string[]> {
  const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
  // Describing every element that passes would take most of the time.
  // The page has no frames, whose results a page of their own would put together.
  const builder = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] });
  if (within !== undefined) builder.include(within);
  const chosen = rules ? builder.withRules([...rules]) : builder.withTags(tags);
  const { violations, passes } = await chosen.analyze();
  expect(passes.length, 'rules that applied').toBeGreaterThan(
    rules ? 0 : within === undefined ? 10 : 4,
  );
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html, failureSummary = '' }) => `${id}: ${html}\n${failureSummary}`),
  );
}
