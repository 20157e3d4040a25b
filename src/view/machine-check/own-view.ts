import { Failure } from '../../core/failure.ts';
import { Session } from '../../document/session.ts';
import { Store } from '../../document/store.ts';
import { Evaluations } from '../../evaluation/evaluations.ts';
import { Kernels } from '../../evaluation/kernels.ts';
import { kernels } from '../../skinning/registry.ts';
import { passes } from '../passes/registry.ts';
import '../skinning-shaders.ts';
import { type CaptureSize, Viewer } from '../viewer.ts';

/** A view with a scene and a context of its own, which the picture on the page does not notice. */
export interface OwnView {
  readonly gl: WebGL2RenderingContext;
  readonly store: Store;
  readonly viewer: Viewer;
  /** Frees the memory of the context at once. */
  dispose(): void;
}

/**
 * Creates an empty view outside of the page, for which every kernel and pass is loaded.
 *
 * @throws Failure without WebGL2
 */
export async function createOwnView({ width, height }: CaptureSize): Promise<OwnView> {
  const canvas = document.createElement('canvas');
  const session = new Session();
  const store = new Store();
  const evaluations = new Evaluations(store, session, new Kernels());
  await evaluations.prepare(kernels.map(({ id }) => id));
  const viewer = new Viewer(canvas, store, session, evaluations, () => undefined);
  viewer.connect({});
  const gl = canvas.getContext('webgl2');
  if (!gl) throw new Failure('This browser has no WebGL2 to check');
  viewer.passes.value = passes;
  viewer.resize(width, height);
  const dispose = () => gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { gl, store, viewer, dispose };
}
