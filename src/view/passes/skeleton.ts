import type { Gpu } from '../../gl/gpu.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import { InstancedSolid } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import type { Programs } from '../programs.ts';
import { boneInstances, jointInstances, type JointMarks } from '../solid-instances.ts';
import { cylinder, sphere } from '../solid-shapes.ts';

/** How much of a bone shows through an opaque skin. */
const throughSkin = 0.55;

/** Spheres at the joints and cylinders along the bones, one instanced draw each. */
export const skeletonPass: Pass = {
  id: 'skeleton',
  create(gpu, programs) {
    const solids = new SkeletonSolids(gpu, programs);
    return {
      draw(frame) {
        if (frame.options.showSkeleton) solids.draw(frame, 1);
      },
      dispose: () => solids.dispose(),
    };
  },
};

/** The skeleton once more, faintly, where an opaque skin hides it. */
export const hiddenSkeletonPass: Pass = {
  id: 'hidden-skeleton',
  create(gpu, programs) {
    const { gl } = gpu;
    const solids = new SkeletonSolids(gpu, programs);
    return {
      draw(frame) {
        const { showSkeleton, showSkin, translucent } = frame.options;
        if (!showSkeleton || !showSkin || translucent) return;
        gl.depthFunc(gl.GREATER);
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        solids.draw(frame, throughSkin);
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => solids.dispose(),
    };
  },
};

class SkeletonSolids {
  private readonly programs: Programs;
  private readonly joints: InstancedSolid;
  private readonly bones: InstancedSolid;

  constructor(gpu: Gpu, programs: Programs) {
    this.programs = programs;
    const program = programs.pass('solid');
    this.joints = new InstancedSolid(gpu, program, sphere());
    this.bones = new InstancedSolid(gpu, program, cylinder());
  }

  draw(frame: Frame, opacity: number): void {
    this.joints.write(concatenate(frame, jointInstances));
    this.bones.write(concatenate(frame, boneInstances));
    const program = this.programs.pass('solid');
    program.use();
    program.set(frame.uniforms);
    program.set({ opacity });
    this.joints.draw();
    this.bones.draw();
  }

  dispose(): void {
    this.joints.dispose();
    this.bones.dispose();
  }
}

function concatenate(
  { characters, options }: Frame,
  instancesOf: (view: CharacterView, marks: JointMarks) => Float32Array,
): Float32Array {
  const marks = { selected: options.selectedJoint, hovered: options.hoveredJoint };
  return Float32Array.from(characters.flatMap((view) => [...instancesOf(view, marks)]));
}
