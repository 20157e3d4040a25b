import { Failure } from '../../core/failure.ts';
import type { Session } from '../../document/session.ts';
import { GpuLimitError } from '../../gl/gpu.ts';
import type { MovieFormatId } from '../../view/movie/movie-settings.ts';
import { type MovieRequest, movieSource } from '../../view/movie/movie-source.ts';
import type { Viewer } from '../../view/viewer.ts';
import { movieFormats } from './formats.ts';
import type { MovieSink } from './movie-format.ts';

/** The work on a movie, as its caller follows it. */
interface MovieWork {
  readonly signal?: AbortSignal;
  /** @param fraction of the frames that are done */
  readonly onProgress?: (label: string, fraction: number) => void;
}

/**
 * Makes a movie, frame by frame.
 *
 * @throws Failure if it can't be made, or if the signal aborts it
 */
export async function makeMovie(
  viewer: Viewer,
  session: Session,
  request: MovieRequest,
  id: MovieFormatId,
  { signal, onProgress }: MovieWork = {},
): Promise<Blob> {
  const format = (movieFormats as Partial<typeof movieFormats>)[id];
  if (!format) throw new Failure(`No movie can be saved as "${id}"`); // a script may ask for it
  // What can't be transparent has its floor and backdrop.
  const background = request.plan.background || !format.isTransparent;
  const plan = { ...request.plan, background };
  const reason = await format.whyNot(plan);
  if (reason !== null) throw new Failure(reason);
  const source = await movieSource(viewer, session, { ...request, plan }, signal);
  let sink: MovieSink | undefined;
  const close = (): void => sink?.close();
  // An encoder that is busy with what nobody wants any more would delay what comes next.
  signal?.addEventListener('abort', close, { once: true });
  try {
    const open = await format.load();
    sink = await open(source);
    const { count } = plan;
    for (let index = 0; index < count; index++) {
      await sink.add(await source.frame(index));
      onProgress?.(`frame ${index + 1} of ${count}`, (index + 1) / count);
    }
    return await sink.finish();
  } catch (error) {
    if (!(error instanceof GpuLimitError)) throw error;
    throw new Failure(`No movie: ${error.message}`, { cause: error });
  } finally {
    signal?.removeEventListener('abort', close);
    close();
    source.release();
  }
}
