import type { Gpu } from '../gl/gpu.ts';
import type { CharacterView } from './character-view.ts';
import type { Frame } from './frame.ts';
import { type InstancedSolid, instanceSize } from './instanced-solid.ts';
import { LimbSolids } from './limb-solids.ts';
import type { Programs } from './programs.ts';
import { boneInstances, boxInstances, jointInstances, keyOf, noMarks } from './solid-instances.ts';

/** Where the color of an instance begins. */
const colorAt = instanceSize - 3;

/** The ghosts of bones, each in one color: those of characters whose skin is not seen. */
export class GhostSolids {
  private readonly solids: LimbSolids;

  constructor(gpu: Gpu, programs: Programs) {
    this.solids = new LimbSolids(gpu, programs);
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
    const { joints, bones, boxes } = this.solids;
    update(joints, style !== 'boxes', jointInstances);
    update(bones, style !== 'boxes', boneInstances);
    update(boxes, style === 'boxes' || style === 'both', boxInstances);
  }

  draw(frame: Frame, opacity: number): void {
    const { joints, bones, boxes } = this.solids;
    this.solids.draw(frame, { opacity, rim: 0 }, joints, bones, boxes);
  }

  dispose(): void {
    this.solids.dispose();
  }
}

type Instances = typeof jointInstances;

function colored(instances: Float32Array, color: readonly number[]): Float32Array {
  for (let at = colorAt; at < instances.length; at += instanceSize) instances.set(color, at);
  return instances;
}
