import type { Editor } from '../../ui/editor.ts';
import { type MovieSettings, plainMovie } from '../../view/movie/movie-settings.ts';
import { labeledRequest } from './labeled-request.ts';
import { makeMovie } from './make-movie.ts';

/** Returns a movie as a file, for scripts. A width and a height are its size. */
export function movieOf(editor: Editor, options: Partial<MovieSettings>): Promise<Blob> {
  const size = options.width === undefined ? plainMovie.size : 'free';
  const settings = { ...plainMovie, size, ...options };
  const { viewer, session } = editor;
  return makeMovie(viewer, session, labeledRequest(editor, settings), settings.format);
}
