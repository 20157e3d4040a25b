import { ratioOf } from '../document/shots.ts';
import { type Actor, boundClip, type Scene } from '../document/scene.ts';
import { type MoviePlan, type MovieSituation, planMovie } from '../view/movie/movie-plan.ts';
import type { MovieSettings } from '../view/movie/movie-settings.ts';
import type { MovieRequest } from '../view/movie/movie-source.ts';
import type { Editor } from './editor.ts';
import { shownShot } from './shots.ts';

/** What a movie is made of. */
type Filming = Pick<Editor, 'store' | 'session' | 'evaluations' | 'viewer' | 'transport' | 'movie'>;

/** What of the page decides which frames a movie has. */
export function movieSituation(editor: Filming): MovieSituation {
  const { store, session, viewer, transport } = editor;
  const other = store.scene.value.actors.map(boundClip).find((clip) => clip !== undefined);
  const clip = transport.clip ?? other;
  return {
    clip: clip ? { start: clip.start, end: clip.end } : null,
    workRange: session.workRange.value,
    now: session.clipTime.value,
    view: viewer.size.value,
    ratio: ratioOf(shownShot(editor)),
  };
}

/** Which frames a movie by the present settings has. */
export function moviePlan(editor: Filming): MoviePlan {
  return planMovie(editor.movie.value, movieSituation(editor));
}

/** What a movie is of: the view, or the inside of a shot's frame. */
export function movieRequest(editor: Filming, settings: MovieSettings): MovieRequest {
  const { store, session, viewer, transport } = editor;
  const plan = planMovie(settings, movieSituation(editor));
  const selected = session.selectedActorId.value;
  const scene = store.scene.value;
  return {
    plan,
    scene: plan.plays ? playedScene(scene, selected, transport.clipIndex) : scene,
    contents: viewer.contents.map((content) => ({ ...content, camera: viewer.camera.value })),
  };
}

/**
 * The scene as Play shows it: the selected character's clip is bound, and no edit over a clip is left.
 */
function playedScene(scene: Scene, selected: number | null, clipIndex: number): Scene {
  const played = (actor: Actor): Actor => {
    const chosen = actor.id === selected && actor.clips[clipIndex] ? clipIndex : null;
    const clip = actor.clip ?? chosen;
    return clip === null ? actor : { ...actor, clip, unkeyed: null };
  };
  return { ...scene, actors: scene.actors.map(played) };
}
