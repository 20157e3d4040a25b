import { pictureLabels } from '../../ui/deform-lab/picture-labels.ts';
import type { Editor } from '../../ui/editor.ts';
import { movieRequest } from '../../ui/movie-request.ts';
import type { MovieSettings } from '../../view/movie/movie-settings.ts';
import type { MovieRequest } from '../../view/movie/movie-source.ts';

/** What a movie is of, with the names of methods that are compared, and their legend. */
export function labeledRequest(editor: Editor, settings: MovieSettings): MovieRequest {
  const request = movieRequest(editor, settings);
  return { ...request, drawOver: pictureLabels(editor, null, request.plan.size) };
}
