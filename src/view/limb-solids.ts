import type { Gpu } from '../gl/gpu.ts';
import type { Frame } from './frame.ts';
import { InstancedSolid } from './instanced-solid.ts';
import type { Programs } from './programs.ts';
import { cube, cylinder, sphere } from './solid-shapes.ts';

/** The solids that represent joints and bones: spheres, cylinders and the file's boxes. */
export class LimbSolids {
  readonly joints: InstancedSolid;
  readonly bones: InstancedSolid;
  readonly boxes: InstancedSolid;
  private readonly programs: Programs;

  constructor(gpu: Gpu, programs: Programs) {
    this.programs = programs;
    const program = programs.pass('solid');
    this.joints = new InstancedSolid(gpu, program, sphere());
    this.bones = new InstancedSolid(gpu, program, cylinder());
    this.boxes = new InstancedSolid(gpu, program, cube());
  }

  /** Draws some of them. */
  draw(
    frame: Frame,
    look: { readonly opacity: number; readonly rim: number },
    ...solids: readonly InstancedSolid[]
  ): void {
    const program = this.programs.pass('solid');
    program.use();
    program.set(frame.uniforms);
    program.set(look);
    for (const solid of solids) solid.draw();
  }

  dispose(): void {
    this.joints.dispose();
    this.bones.dispose();
    this.boxes.dispose();
  }
}
