import type { Gpu } from '../../gl/gpu.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import { InstancedSolid } from '../instanced-solid.ts';
import type { Pass } from '../pass.ts';
import type { Programs } from '../programs.ts';
import {
  boneInstances,
  boxInstances,
  jointInstances,
  type JointMarks,
} from '../solid-instances.ts';
import { cube, cylinder, sphere } from '../solid-shapes.ts';

/** How much of a bone shows through an opaque skin. */
const throughSkin = 0.55;

/** Spheres at the joints, cylinders along the bones, boxes of the file: one instanced draw each. */
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

/** All solids that stand for joints and bones. */
class SkeletonSolids {
  private readonly programs: Programs;
  private readonly joints: InstancedSolid;
  private readonly bones: InstancedSolid;
  private readonly boxes: InstancedSolid;

  constructor(gpu: Gpu, programs: Programs) {
    this.programs = programs;
    const program = programs.pass('solid');
    this.joints = new InstancedSolid(gpu, program, sphere());
    this.bones = new InstancedSolid(gpu, program, cylinder());
    this.boxes = new InstancedSolid(gpu, program, cube());
  }

  draw(frame: Frame, opacity: number): void {
    const withSticks = frame.characters.filter((view) => showsSticks(view, frame));
    const withBoxes = frame.characters.filter((view) => showsBoxes(view, frame));
    this.joints.write(concatenate(withSticks, frame, jointInstances));
    this.bones.write(concatenate(withSticks, frame, boneInstances));
    this.boxes.write(concatenate(withBoxes, frame, boxInstances));
    const program = this.programs.pass('solid');
    program.use();
    program.set(frame.uniforms);
    program.set({ opacity, rim: 1 });
    this.joints.draw();
    this.bones.draw();
    // Faces are flat: a rim would make the whole of a slanting one dark.
    program.set({ rim: 0 });
    this.boxes.draw();
  }

  dispose(): void {
    this.joints.dispose();
    this.bones.dispose();
    this.boxes.dispose();
  }
}

/** A character without boxes shows sticks in their place. */
function showsSticks(view: CharacterView, { options }: Frame): boolean {
  return options.skeletonStyle !== 'boxes' || !view.state.character.skeleton.displayBoxes;
}

function showsBoxes(view: CharacterView, { options }: Frame): boolean {
  return options.skeletonStyle !== 'sticks' && view.state.character.skeleton.displayBoxes !== null;
}

function concatenate(
  views: readonly CharacterView[],
  { options }: Frame,
  instancesOf: (view: CharacterView, marks: JointMarks) => Float32Array,
): Float32Array {
  const marks = { selected: options.selectedJoint, hovered: options.hoveredJoint };
  return Float32Array.from(views.flatMap((view) => [...instancesOf(view, marks)]));
}
