/** Into how many parts a span is divided to find where a difference is largest. */
const parts = 8;
/** How often the parts around the largest one are narrowed by a third. */
const steps = 24;

/**
 * The largest difference between times: of several times in each span, and of more around the one with
 * the largest.
 *
 * @param times increasing
 * @param differenceAt is smooth in each span
 */
export function largestBetween(
  times: readonly number[],
  differenceAt: (time: number) => number,
): number {
  let largest = 0;
  let [from, to] = [0, 0];
  times.slice(1).forEach((end, span) => {
    const start = times[span]!;
    const step = (end - start) / parts;
    for (let part = 1; part < parts; part++) {
      const time = start + step * part;
      const difference = differenceAt(time);
      if (difference > largest) [largest, from, to] = [difference, time - step, time + step];
    }
  });
  for (let step = 0; step < steps && to > from; step++) {
    const third = (to - from) / 3;
    const [early, late] = [differenceAt(from + third), differenceAt(to - third)];
    largest = Math.max(largest, early, late);
    if (early < late) from += third;
    else to -= third;
  }
  return largest;
}

/** Two digits of the largest difference, rounded up, so that "at most" is true of them. */
export function atMost(largest: number): number {
  const near = Number(largest.toPrecision(2));
  if (near >= largest) return near;
  const digit = 10 ** (Math.floor(Math.log10(largest)) - 1);
  return Number((near + digit).toPrecision(2));
}
