import type { Evaluation } from '../../evaluation/evaluation.ts';
import type { Overrides } from '../../evaluation/evaluations.ts';
import type { Frame } from '../frame.ts';
import type { RenderView } from '../render-view.ts';
import type { Renderer } from '../renderer.ts';
import type { ViewOptions } from '../view-options.ts';
import type { Viewer } from '../viewer.ts';

/** What was shown at one moment. */
export interface HeldMoment {
  readonly shown: readonly Evaluation[];
  release(): void;
}

/**
 * Returns what is shown at this moment, for a picture that takes longer. Until it is released, it
 * keeps its objects on the GPU.
 */
export function holdMoment(viewer: Viewer, overrides?: Overrides): HeldMoment {
  const shown = viewer.evaluations.visible(overrides).map((evaluation) => evaluation.still());
  for (const still of shown) viewer.held.add(still);
  // Skinning them empties the canvas, as drawing of any kind does before it is shown.
  viewer.requestFrame();
  const release = (): void => {
    for (const still of shown) {
      viewer.held.delete(still);
      still.dispose();
    }
    viewer.requestFrame();
  };
  return { shown, release };
}

/**
 * Draws a view beside the page, without its overlay. The caller must first check that the viewer is
 * `available`.
 *
 * @param shown evaluations that are held
 */
export function drawApart<Result>(
  viewer: Viewer,
  view: RenderView,
  shown: readonly Evaluation[],
  changed: Partial<ViewOptions>,
  draw: (renderer: Renderer, frame: Frame) => Result,
): Result {
  const options = { showOverlay: false, ...changed };
  const [frame] = viewer.createFrames([view], options, 'full', shown);
  return draw(viewer.present(), frame!);
}
