import type { Frame } from '../frame.ts';
import { InstancedSolid } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import { boneInstances, jointInstances } from '../solid-instances.ts';
import { cylinder, sphere } from '../solid-shapes.ts';
import type { CharacterView } from '../character-view.ts';

/** How much of a bone shows through the skin. */
const throughSkin = 0.55;

/** Spheres at the joints and cylinders along the bones, one instanced draw each. */
export const skeletonPass: Pass = {
  id: 'skeleton',
  create(gpu, programs) {
    const { gl } = gpu;
    const program = programs.pass('solid');
    const joints = new InstancedSolid(gpu, program, sphere());
    const bones = new InstancedSolid(gpu, program, cylinder());
    return {
      draw(frame) {
        if (!frame.options.showSkeleton) return;
        joints.write(concatenate(frame.characters, frame, jointInstances));
        bones.write(concatenate(frame.characters, frame, boneInstances));
        program.use();
        program.set(frame.uniforms);
        program.set({ opacity: 1 });
        joints.draw();
        bones.draw();
        if (!frame.options.showSkin) return;
        // Once more where something hides them: the skin, for the most part.
        gl.depthFunc(gl.GREATER);
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        program.set({ opacity: throughSkin });
        joints.draw();
        bones.draw();
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose() {
        joints.dispose();
        bones.dispose();
      },
    };
  },
};

function concatenate(
  views: readonly CharacterView[],
  { options }: Frame,
  instancesOf: (view: CharacterView, selected: number | null) => Float32Array,
): Float32Array {
  return Float32Array.from(views.flatMap((view) => [...instancesOf(view, options.selectedJoint)]));
}
