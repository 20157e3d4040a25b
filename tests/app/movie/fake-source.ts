import { planMovie, type MoviePlan } from '../../../src/view/movie/movie-plan.ts';
import { type MovieSettings, plainMovie } from '../../../src/view/movie/movie-settings.ts';
import type { MovieSource } from '../../../src/view/movie/movie-source.ts';
import type { Evaluation } from '../../../src/evaluation/evaluation.ts';
import type { Picture } from '../../../src/view/picture/encode-picture.ts';

/** The plan of a movie of a clip of two seconds. */
export function planOf(settings: Partial<MovieSettings>): MoviePlan {
  return planMovie(
    { ...plainMovie, size: 'free', ...settings },
    {
      ...{ clip: { start: 0, end: 2 }, workRange: null, now: 0, ratio: null },
      view: { width: 640, height: 480 },
    },
  );
}

/** Frames whose pixels are computed from their number, column and row. */
export function sourceOf(
  plan: MoviePlan,
  colorOf: (frame: number, x: number, y: number) => readonly [number, number, number, number],
  selected?: Evaluation,
): MovieSource {
  const { width, height } = plan.size;
  const draw = (index: number): Picture => {
    const pixels = new Uint8ClampedArray(width * height * 4);
    for (let at = 0; at < width * height; at++) {
      pixels.set(colorOf(index, at % width, Math.floor(at / width)), at * 4);
    }
    return { width, height, pixels };
  };
  return {
    plan,
    frame: (index) =>
      Promise.resolve({
        index,
        picture: () => Promise.resolve(draw(index)),
        selected: () => selected,
      }),
    release: () => undefined,
  };
}
