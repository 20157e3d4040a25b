import AxeBuilder from '@axe-core/playwright';
import { expect, type Page } from '@playwright/test';

/**
 * What a checker can detect of WCAG 2.2 AA on the page as it is: names, roles, contrast and the order
 * of headings.
 *
 * @param rules that are checked; all of them if absent
 */
export async function violations(page: Page, rules?: readonly string[]): Promise<string[]> {
  const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
  const builder = new AxeBuilder({ page });
  const chosen = rules ? builder.withRules([...rules]) : builder.withTags(tags);
  const { violations, passes } = await chosen.analyze();
  expect(passes.length, 'rules that applied').toBeGreaterThan(rules ? 0 : 10);
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html, failureSummary = '' }) => `${id}: ${html}\n${failureSummary}`),
  );
}
