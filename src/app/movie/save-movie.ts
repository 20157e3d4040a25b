import type { Editor, MovieChoice } from '../../ui/editor.ts';
import type { MoviePlan } from '../../view/movie/movie-plan.ts';
import { download } from '../../ui/download.ts';
import { movieFormats } from './formats.ts';
import { labeledRequest } from './labeled-request.ts';
import { makeMovie } from './make-movie.ts';

/** Makes a movie by the present settings, offers it as a download, and says so. */
export async function saveMovie(editor: Editor): Promise<void> {
  const { viewer, session, notice } = editor;
  // The scene is read now, so that it is that of the moment in which the user asked.
  const request = labeledRequest(editor, editor.movie.value);
  const { format: id } = editor.movie.value;
  const name = `${editor.evaluations.selected()?.state.name ?? 'movie'}${movieFormats[id].ending}`;
  const movie = await editor.whileWorking('Movie', (signal, onProgress) =>
    makeMovie(viewer, session, request, id, { signal, onProgress }),
  );
  if (!movie) return;
  download(name, movie, movie.type);
  const { count } = request.plan;
  notice.value = `${name} saved: ${count} ${count === 1 ? 'frame' : 'frames'}`;
}

/** Returns all forms in which a movie may be saved, and what keeps this browser from some. */
export function movieChoices(plan: MoviePlan): Promise<readonly MovieChoice[]> {
  return Promise.all(
    Object.values(movieFormats).map(async (format) => ({
      id: format.id,
      label: format.label,
      isTransparent: format.isTransparent,
      whyNot: await format.whyNot(plan),
      bytes: format.bytesOf(plan),
    })),
  );
}
