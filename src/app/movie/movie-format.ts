import type { MovieFormatId } from '../../view/movie/movie-settings.ts';
import type { MoviePlan } from '../../view/movie/movie-plan.ts';
import type { MovieFrame, MovieSource } from '../../view/movie/movie-source.ts';

/** A file that grows frame by frame. */
export interface MovieSink {
  /** Adds the next frame, and returns when there is room for another. */
  add(frame: MovieFrame): Promise<void>;
  /** Returns the file after the last frame. */
  finish(): Promise<Blob>;
  /** Frees everything, at any time, also more than once. */
  close(): void;
}

/** A form in which movies are saved. To add one, write a file and add a row to formats.ts. */
export interface MovieFormat {
  readonly id: MovieFormatId;
  readonly label: string;
  /** What the name of a file ends with. */
  readonly ending: string;
  /** Whether frames may be transparent. */
  readonly isTransparent: boolean;
  /** The reason why this browser can't save such a movie, or null if it can. */
  whyNot(plan: MoviePlan): Promise<string | null>;
  /** About how many bytes the file has. */
  bytesOf(plan: MoviePlan): number;
  readonly load: () => Promise<OpenSink>;
}

/** Begins a file of the frames of a source. */
export type OpenSink = (source: MovieSource) => Promise<MovieSink>;

/** The number of pixels of all frames. */
export function pixelsOf({ size, count }: MoviePlan): number {
  return size.width * size.height * count;
}

export const always = (): Promise<null> => Promise.resolve(null);
