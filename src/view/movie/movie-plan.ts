import { Failure } from '../../core/failure.ts';
import type { CaptureSize } from '../viewer.ts';
import type { MovieFormatId, MovieSettings, MovieSizeId } from './movie-settings.ts';

/** What of the page decides which frames a movie has. */
export interface MovieSituation {
  /** The range of the clip that plays, in seconds; null if there is none. */
  readonly clip: { readonly start: number; readonly end: number } | null;
  readonly workRange: readonly [number, number] | null;
  /** The time that is shown now, in seconds of the clip. */
  readonly now: number;
  /** The size of the view in pixels. */
  readonly view: CaptureSize;
  /** Width by height of the shot that is shown, or null. */
  readonly ratio: number | null;
}

/** Which frames a movie has. */
export interface MoviePlan {
  readonly size: CaptureSize;
  /** Whether the size that was asked for has odd sides, which video can't have. */
  readonly isTrimmed: boolean;
  /** Frames a second. */
  readonly rate: number;
  readonly count: number;
  /** The clip's time of the first frame, in seconds. */
  readonly start: number;
  /** Whether the clip's time goes on from frame to frame. */
  readonly plays: boolean;
  /** Whether the camera turns once about its target. */
  readonly turns: boolean;
  readonly samples: number;
  readonly background: boolean;
}

const presets: Readonly<Record<Exclude<MovieSizeId, 'view' | 'free'>, CaptureSize>> = {
  '360p': { width: 640, height: 360 },
  '720p': { width: 1280, height: 720 },
  '1080p': { width: 1920, height: 1080 },
  '4k': { width: 3840, height: 2160 },
  square: { width: 1080, height: 1080 },
};

/** Video stores color for squares of 2 × 2 pixels. */
const needsEvenSides: readonly MovieFormatId[] = ['webm', 'mp4'];

/** A movie of more frames is more likely a slip than a wish: ten minutes at 60 a second. */
const mostFrames = 36_000;

/** Returns which frames a movie has by its settings. */
export function planMovie(settings: MovieSettings, situation: MovieSituation): MoviePlan {
  const { rate, turns, turnSeconds, samples, background } = settings;
  const plays = settings.plays && situation.clip !== null;
  const [from, to] = rangeOf(settings, situation);
  const seconds = turns ? turnSeconds : to - from;
  return {
    ...sizeOf(settings, situation),
    count: Math.max(1, Math.round(seconds * rate)),
    start: plays ? from : situation.now,
    ...{ rate, plays, turns, samples, background },
  };
}

/** Throws a `Failure` for a movie that can't be made. */
export function checkPlan({ count, rate }: MoviePlan): void {
  if (!(rate > 0 && rate <= 240)) {
    throw new Failure('A movie has more than 0 and at most 240 frames a second');
  }
  if (!(count <= mostFrames)) {
    const most = mostFrames.toLocaleString('en');
    throw new Failure(`A movie has at most ${most} frames; this one would have more`);
  }
}

/**
 * The clip's time of a frame, in seconds. It is computed from the frame's number alone, so that no
 * error adds up.
 */
export function frameTime({ start, rate, plays }: MoviePlan, frame: number): number {
  return plays ? start + frame / rate : start;
}

/**
 * How far the camera has turned at a frame, in radians. The frame after the last would be the first
 * one again.
 */
export function frameTurn({ count, turns }: MoviePlan, frame: number): number {
  return turns ? (2 * Math.PI * frame) / count : 0;
}

/** How long the movie is, in seconds. */
export function movieSeconds({ count, rate }: MoviePlan): number {
  return count / rate;
}

function rangeOf(
  { range, from, to }: MovieSettings,
  { clip, workRange }: MovieSituation,
): readonly [number, number] {
  if (range === 'work' && workRange) return workRange;
  if (range !== 'typed' && clip) return [clip.start, clip.end];
  return [Math.min(from, to), Math.max(from, to)];
}

function sizeOf(
  { format, size, width, height }: MovieSettings,
  { view, ratio }: MovieSituation,
): Pick<MoviePlan, 'size' | 'isTrimmed'> {
  const wanted = size === 'view' ? view : size === 'free' ? { width, height } : presets[size];
  const framed =
    ratio === null ? wanted : { width: Math.round(wanted.height * ratio), height: wanted.height };
  const step = needsEvenSides.includes(format) ? 2 : 1;
  const side = (pixels: number): number => Math.max(step, Math.floor(pixels / step) * step);
  const sized = { width: side(framed.width), height: side(framed.height) };
  const isTrimmed = sized.width !== framed.width || sized.height !== framed.height;
  return { size: sized, isTrimmed };
}
