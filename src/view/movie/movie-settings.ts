/** The forms in which a movie is saved; `src/app/movie/formats.ts` has their writers. */
export type MovieFormatId = 'webm' | 'mp4' | 'gif' | 'png' | 'obj';

export type MovieSizeId = 'view' | '360p' | '720p' | '1080p' | '4k' | 'square' | 'free';

/** What of the clip a movie shows: all of it, the work range, or times that were typed. */
export type MovieRangeId = 'clip' | 'work' | 'typed';

/** How movies are saved. */
export interface MovieSettings {
  readonly format: MovieFormatId;
  readonly size: MovieSizeId;
  /** The size in pixels where `size` is free; a shot's aspect decides over the width. */
  readonly width: number;
  readonly height: number;
  /** Frames a second. */
  readonly rate: number;
  readonly range: MovieRangeId;
  /** The typed range, in seconds of the clip. */
  readonly from: number;
  readonly to: number;
  /** Whether clips play; otherwise every frame shows the pose of the moment. */
  readonly plays: boolean;
  /** Whether the camera turns once about its target, which then takes `turnSeconds`. */
  readonly turns: boolean;
  readonly turnSeconds: number;
  /** Samples on each side of a pixel. */
  readonly samples: number;
  /** Whether floor and backdrop are drawn; without them a movie is transparent, where it can be. */
  readonly background: boolean;
}

export const plainMovie: MovieSettings = {
  ...{ format: 'webm', size: '720p', width: 1280, height: 720, rate: 30 },
  ...{ range: 'clip', from: 0, to: 2, plays: true, turns: false, turnSeconds: 4 },
  ...{ samples: 1, background: true },
};

/** Rates that are offered, in frames a second; any other may be typed. */
export const usualRates: readonly number[] = [24, 25, 30, 60];
