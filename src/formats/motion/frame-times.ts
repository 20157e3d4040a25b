/** More frames than anybody waits for. */
const mostFrames = 200_000;
/** Frames as near to a key in seconds as this are left out. */
const sameTime = 1e-4;

/**
 * The times at which a motion is sampled: its keys and the whole frames between the first and the
 * last time, increasing; null if these are too many.
 *
 * @param keys times in seconds that are sampled in any case
 */
export function frameTimes(
  [first, last]: readonly [number, number],
  fps: number,
  keys: Iterable<number>,
): readonly number[] | null {
  if ((last - first) * fps > mostFrames) return null;
  const own = [...new Set([first, last, ...keys])]
    .filter((time) => time >= first && time <= last)
    .sort((a, b) => a - b);
  const times: number[] = [];
  own.forEach((time, at) => {
    times.push(time);
    const next = own[at + 1] ?? time;
    for (let frame = Math.floor(time * fps) + 1; frame / fps < next - sameTime; frame++) {
      if (frame / fps > time + sameTime) times.push(frame / fps);
    }
  });
  return times;
}
