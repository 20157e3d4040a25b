import { InstancedSolid } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import { axisInstances, boneAxisInstances, keyOf } from '../solid-instances.ts';
import { cylinder } from '../solid-shapes.ts';

/**
 * Draws the axes of the file's space and, with the skeleton, of every joint: X red, Y green, Z
 * blue. If bones are lines, it draws the frame t, n, b of each bone in these colors instead.
 */
export const axesPass: Pass = {
  id: 'axes',
  isShown: ({ showAxes }) => showAxes,
  create(gpu, programs) {
    const { gl } = gpu;
    const program = programs.pass('solid');
    const axes = new InstancedSolid(gpu, program, cylinder());
    return {
      draw(frame) {
        const { showSkeleton, skeletonStyle } = frame.options;
        const ofBones = showSkeleton && skeletonStyle === 'lines';
        const ofJoints = showSkeleton && !ofBones;
        axes.update(`${ofJoints} ${ofBones} ${keyOf(frame.characters)}`, () =>
          frame.characters.flatMap((view) => [
            axisInstances(view, ofJoints),
            ...(ofBones ? [boneAxisInstances(view)] : []),
          ]),
        );
        program.use();
        program.set(frame.uniforms);
        program.set({ opacity: 1, rim: 1 });
        // Axes are drawn over everything, because they are for reading and not for looks.
        gl.clear(gl.DEPTH_BUFFER_BIT);
        axes.draw();
      },
      dispose: () => axes.dispose(),
    };
  },
};
