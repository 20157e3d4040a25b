import { bonesOf } from '../../core/bones.ts';
import type { Frame } from '../frame.ts';
import { InstancedSolid } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import { boneLineInstances, keyOf, litBoneInstance, marksOf } from '../solid-instances.ts';
import { lineGrid, segment } from '../solid-shapes.ts';
import type { ViewOptions } from '../view-options.ts';

/** The number of cells on each side of the grid that is wrapped to a cylinder. */
const gridSize = 8;
/** The opacity of what an opaque skin hides, and of what a translucent one does. */
const [hiddenOpacity, innerOpacity] = [0.35, 0.8];
/** The line widths in pixels. */
const [boneWidth, gridWidth] = [2.5, 1.25];

/**
 * Draws CS354's bones with one line each, all in one draw call, and a wireframe cylinder around the
 * bone under the pointer. What is hidden shows through.
 */
export const boneLinesPass: Pass = {
  id: 'bone-lines',
  isShown: showsLines,
  isMirrored: true,
  create(gpu, programs) {
    const { gl } = gpu;
    const program = programs.pass('line');
    const bones = new InstancedSolid(gpu, program, segment());
    const lit = new InstancedSolid(gpu, program, lineGrid(gridSize));
    return {
      draw(frame) {
        const { options } = frame;
        bones.update(keyOf(frame.characters, options), () =>
          frame.characters.map((view) => boneLineInstances(view, marksOf(view, options))),
        );
        updateLit(frame);
        program.use();
        program.set(frame.uniforms);
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        drawBoth(frame, gl.GREATER, options.translucent ? innerOpacity : hiddenOpacity);
        drawBoth(frame, gl.LEQUAL, 1);
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose() {
        bones.dispose();
        lit.dispose();
      },
    };

    function updateLit({ characters, options: { hoveredLimb } }: Frame): void {
      const { actorId, bone } = hoveredLimb ?? {};
      const view = characters.find(({ state }) => state.id === actorId);
      const index = view && bone ? bonesOf(view.state.character).indexOf(bone) : -1;
      lit.update(view ? `${index} ${keyOf([view])}` : '', () =>
        view && bone ? [litBoneInstance(view, bone)] : [],
      );
    }

    function drawBoth({ scale }: Frame, depthFunction: number, opacity: number): void {
      gl.depthFunc(depthFunction);
      program.set({ opacity, wrapped: false, lineWidth: boneWidth * scale });
      bones.draw();
      program.set({ wrapped: true, lineWidth: gridWidth * scale });
      lit.draw();
    }
  },
};

function showsLines({ showSkeleton, skeletonStyle }: ViewOptions): boolean {
  return showSkeleton && skeletonStyle === 'lines';
}
