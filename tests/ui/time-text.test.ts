import { expect, it } from 'vitest';
import { timeText } from '../../src/ui/time-text.ts';

const now = new Date(2026, 2, 1, 0, 5);

it.each([
  [new Date(2026, 2, 1, 0, 4), /^today 12:04/],
  [new Date(2026, 1, 28, 23, 59), /^yesterday 11:59/],
  [new Date(2026, 1, 27, 9, 41), /^Feb 27, 2026 09:41/],
])('%s is told by the calendar, not by hours', (time, text) => {
  expect(timeText(time, now, 'en-US')).toMatch(text);
});
