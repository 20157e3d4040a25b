const dayLength = 24 * 60 * 60 * 1000;

/** Says when something was: "today 14:03", "yesterday 9:41" or "12 Nov 2026 14:03". */
export function timeText(time: Date, now: Date, locale?: string): string {
  const days = Math.round((startOfDay(now) - startOfDay(time)) / dayLength);
  const clock = time.toLocaleTimeString(locale, { hour: '2-digit', minute: '2-digit' });
  if (days === 0) return `today ${clock}`;
  if (days === 1) return `yesterday ${clock}`;
  return `${time.toLocaleDateString(locale, { dateStyle: 'medium' })} ${clock}`;
}

function startOfDay(time: Date): number {
  return new Date(time.getFullYear(), time.getMonth(), time.getDate()).getTime();
}
