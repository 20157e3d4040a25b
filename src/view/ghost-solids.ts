import type { Gpu } from '../gl/gpu.ts';
import type { CharacterView } from './character-view.ts';
import type { Frame } from './frame.ts';
import { InstancedSolid, instanceSize } from './instanced-solid.ts';
import type { Programs } from './programs.ts';
import { boneInstances, boxInstances, jointInstances, keyOf, noMarks } from './solid-instances.ts';
import { cube, cylinder, sphere } from './solid-shapes.ts';

/** Where the color of an instance begins. */
const colorAt = instanceSize - 3;

/** The ghosts of bones, each in one color: those of characters whose skin is not seen. */
export class GhostSolids {
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

  /** Takes the bones of the next ghost, in linear light. */
  show(view: CharacterView, { options }: Frame, color: readonly number[]): void {
    const { displayBoxes } = view.state.character.skeleton;
    const style = displayBoxes ? options.skeletonStyle : 'sticks';
    const key = `${keyOf([view])} ${color.join()}`;
    const update = (solid: InstancedSolid, isShown: boolean, instancesOf: Instances): void => {
      solid.update(`${key} ${isShown}`, () => [
        isShown ? colored(instancesOf(view, noMarks), color) : new Float32Array(0),
      ]);
    };
    update(this.joints, style !== 'boxes', jointInstances);
    update(this.bones, style !== 'boxes', boneInstances);
    update(this.boxes, style === 'boxes' || style === 'both', boxInstances);
  }

  draw(frame: Frame, opacity: number): void {
    const program = this.programs.pass('solid');
    program.use();
    program.set(frame.uniforms);
    program.set({ opacity, rim: 0 });
    this.joints.draw();
    this.bones.draw();
    this.boxes.draw();
  }

  dispose(): void {
    this.joints.dispose();
    this.bones.dispose();
    this.boxes.dispose();
  }
}

type Instances = typeof jointInstances;

function colored(instances: Float32Array, color: readonly number[]): Float32Array {
  for (let at = colorAt; at < instances.length; at += instanceSize) instances.set(color, at);
  return instances;
}
