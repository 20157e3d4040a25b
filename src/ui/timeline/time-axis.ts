/** What the timeline shows from left to right, in seconds. */
export type TimeWindow = readonly [start: number, end: number];

/** The shortest time that can be shown, in seconds. */
const shortest = 0.02;
const longest = 1e6;

/** The place of a time, from 0 at the left edge to the width at the right one. */
export function xOfTime([start, end]: TimeWindow, width: number, time: number): number {
  return ((time - start) / (end - start)) * width;
}

export function timeAtX([start, end]: TimeWindow, width: number, x: number): number {
  return start + (x / width) * (end - start);
}

/** Shows more time if the factor exceeds 1, less otherwise; a time stays where it is. */
export function zoomed([start, end]: TimeWindow, about: number, factor: number): TimeWindow {
  const length = Math.min(Math.max((end - start) * factor, shortest), longest);
  const by = length / (end - start);
  return [about + (start - about) * by, about + (end - about) * by];
}

export function panned([start, end]: TimeWindow, seconds: number): TimeWindow {
  return [start + seconds, end + seconds];
}

/** The window that shows a range with some room at both sides. */
export function framing([start, end]: TimeWindow): TimeWindow {
  const length = Math.max(end - start, shortest);
  const room = length * 0.04;
  const middle = (start + end) / 2;
  return [middle - length / 2 - room, middle + length / 2 + room];
}

/** The nearest time that is a frame. */
export function atFrame(time: number, fps: number): number {
  return Math.round(time * fps) / fps;
}
