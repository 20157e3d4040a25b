import { Failure } from '../../core/failure.ts';
import type { Scene } from '../../document/scene.ts';
import type { Session } from '../../document/session.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { kernelOf } from '../../skinning/registry.ts';
import { type DrawOver, drawnOver } from '../picture/draw-over.ts';
import type { Picture } from '../picture/encode-picture.ts';
import { makePicture, type PictureWork } from '../picture/make-picture.ts';
import { checkPictureSize } from '../picture/picture-tiles.ts';
import type { ViewContent } from '../render-view.ts';
import { turnOfPage } from '../turn-of-page.ts';
import type { Viewer } from '../viewer.ts';
import { checkPlan, frameTime, frameTurn, type MoviePlan } from './movie-plan.ts';
import { MovieScene } from './movie-scene.ts';

/** One frame, until the next is asked for. */
export interface MovieFrame {
  readonly index: number;
  /** Draws it, as a still of its time is drawn. */
  picture(): Promise<Picture>;
  /** The selected character at its time, if there is one. */
  selected(): Evaluation | undefined;
}

/** The frames of a movie, which may be asked for in any order, one at a time. */
export interface MovieSource {
  readonly plan: MoviePlan;
  /** @throws Failure if the work was canceled */
  frame(index: number): Promise<MovieFrame>;
  release(): void;
}

/** What a movie is of. */
export interface MovieRequest {
  readonly plan: MoviePlan;
  readonly scene: Scene;
  /** The views at the first frame, side by side. */
  readonly contents: readonly ViewContent[];
  /** Draws over each frame. */
  readonly drawOver?: DrawOver | null;
}

/**
 * Returns the frames of a movie of a scene, whatever happens to the page's own meanwhile. Its caller
 * releases it.
 */
export async function movieSource(
  viewer: Viewer,
  session: Session,
  { plan, scene, contents, drawOver }: MovieRequest,
  signal?: AbortSignal,
): Promise<MovieSource> {
  checkPlan(plan);
  checkPictureSize(plan.size);
  if (!viewer.available.value)
    throw new Failure('There is no view to make a movie of at the moment');
  const held = new MovieScene(viewer, scene, session);
  const { size, samples, background } = plan;
  const beside = contents.flatMap(({ overrides: { deformation } }) =>
    scene.actors.map((actor) => kernelOf({ ...actor, ...deformation }).id),
  );
  const { hold, options } = held;
  const request = { size, samples, showSurroundings: background, hold, options };
  const work: PictureWork = signal ? { signal } : {};
  try {
    held.seek(frameTime(plan, 0));
    await settle();
    for (const { overrides } of contents) held.hold(overrides);
    await viewer.texturesShown();
  } catch (error) {
    held.release();
    throw error;
  }
  return {
    plan,
    async frame(index) {
      await turnOfPage();
      if (signal?.aborted) throw new Failure('Canceled');
      held.seek(frameTime(plan, index));
      await settle();
      const turned = contents.map((content) => turnedBy(content, frameTurn(plan, index)));
      return {
        index,
        picture: async () =>
          drawnOver(await makePicture(viewer, { ...request, contents: turned }, work), drawOver),
        selected: () => held.evaluations.selected(),
      };
    },
    release: () => held.release(),
  };

  function settle(): Promise<void> {
    return held.evaluations.settled(beside);
  }
}

function turnedBy(content: ViewContent, angle: number): ViewContent {
  const { camera } = content;
  return { ...content, camera: { ...camera, azimuth: camera.azimuth + angle } };
}
