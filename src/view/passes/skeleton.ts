import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { InstancedSolid } from '../instanced-solid.ts';
import { LimbSolids } from '../limb-solids.ts';
import type { Pass } from '../pass.ts';
import {
  boneInstances,
  boxInstances,
  jointInstances,
  type JointMarks,
  keyOf,
  marksOf,
} from '../solid-instances.ts';

/** The opacity of a bone that shows through an opaque skin. */
const throughSkin = 0.55;
/** The opacity of boxes around the skin, which look like glass. */
const glass = 0.3;

/**
 * Draws spheres at the joints, cylinders along the bones and the file's boxes, each kind in one
 * instanced draw call.
 */
export const skeletonPass: Pass = {
  id: 'skeleton',
  isShown: ({ showSkeleton }) => showSkeleton,
  isMirrored: true,
  create(gpu, programs) {
    const solids = new LimbSolids(gpu, programs);
    return {
      draw(frame) {
        drawSticks(solids, frame, 1);
        if (!frame.options.showSkin) drawBoxes(solids, frame, 1);
      },
      dispose: () => solids.dispose(),
    };
  },
};

/**
 * If there is a skin, draws the skeleton again, faintly, where the skin hides it, and boxes around
 * the skin.
 */
export const hiddenSkeletonPass: Pass = {
  id: 'hidden-skeleton',
  isShown: ({ showSkeleton, showSkin }) => showSkeleton && showSkin,
  isMirrored: true,
  create(gpu, programs) {
    const { gl } = gpu;
    const solids = new LimbSolids(gpu, programs);
    return {
      draw(frame) {
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gl.depthFunc(gl.GREATER);
        if (!frame.options.translucent) drawSticks(solids, frame, throughSkin);
        gl.depthFunc(gl.ALWAYS);
        gl.enable(gl.CULL_FACE);
        drawBoxes(solids, frame, glass);
        gl.disable(gl.CULL_FACE);
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => solids.dispose(),
    };
  },
};

function drawSticks(solids: LimbSolids, frame: Frame, opacity: number): void {
  const { joints, bones } = solids;
  const views = frame.characters.filter((view) => showsSticks(view, frame));
  update(joints, views, frame, jointInstances);
  update(bones, views, frame, boneInstances);
  solids.draw(frame, { opacity, rim: 1 }, joints, bones);
}

function drawBoxes(solids: LimbSolids, frame: Frame, opacity: number): void {
  const views = frame.characters.filter((view) => showsBoxes(view, frame));
  update(solids.boxes, views, frame, boxInstances);
  // Faces are flat, so a rim would make all of a slanted one dark.
  solids.draw(frame, { opacity, rim: 0 }, solids.boxes);
}

/** A character without boxes shows sticks instead. */
function showsSticks(view: CharacterView, { options }: Frame): boolean {
  if (options.skeletonStyle === 'lines') return false;
  return options.skeletonStyle !== 'boxes' || !view.state.character.skeleton.displayBoxes;
}

function showsBoxes(view: CharacterView, { options }: Frame): boolean {
  const { skeletonStyle } = options;
  if (skeletonStyle !== 'boxes' && skeletonStyle !== 'both') return false;
  return view.state.character.skeleton.displayBoxes !== null;
}

function update(
  solid: InstancedSolid,
  views: readonly CharacterView[],
  { options }: Frame,
  instancesOf: (view: CharacterView, marks: JointMarks) => Float32Array,
): void {
  solid.update(keyOf(views, options), () =>
    views.map((view) => instancesOf(view, marksOf(view, options))),
  );
}
