import type { Skin } from '../core/skin.ts';
import type { Actor } from '../document/scene.ts';
import type { SkinDevice } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Program } from '../gl/program.ts';
import type { DisplayTransform } from '../evaluation/display-transform.ts';
import type { ActorDress } from './dress/actor-dress.ts';
import type { GpuPools } from './gpu-pools.ts';
import { dressCode, needsDress, type OnImage } from './lazy-dress.ts';
import type { Programs } from './programs.ts';
import { type LayoutChoice, SkinnedMesh } from './skinned-mesh.ts';
import { type Subject, subjectOf } from './subject.ts';
import { type Surface, surfacesOf } from './surfaces.ts';

/** A character of the document with its objects on the GPU, which are updated on demand. */
export class CharacterView {
  private skin: Skin;
  readonly skinned: SkinnedMesh;
  readonly surfaces: readonly Surface[];
  /** What covers the surfaces; null while nothing does, or while the code for it loads. */
  dress: ActorDress | null = null;
  readonly evaluation: Evaluation;
  /** The milliseconds that the last change of pose took on the CPU. */
  poseMilliseconds = 0;
  private readonly createDress: (Dress: typeof ActorDress) => ActorDress;
  private readonly onImage: OnImage;
  private dressing: Promise<void> | null = null;
  private isDisposed = false;
  private shownDevice: SkinDevice | null = null;
  private shownRest = 0;
  private shownVertices = 0;
  private shownNormals = 0;
  private enclosed: { readonly revision: string; readonly subject: Subject } | null = null;

  constructor(
    gpu: Gpu,
    programs: Programs,
    pools: GpuPools,
    evaluation: Evaluation,
    onImage: OnImage,
    layout?: LayoutChoice,
  ) {
    const { character } = evaluation.state;
    this.evaluation = evaluation;
    this.skin = evaluation.skin;
    this.skinned = new SkinnedMesh(gpu, programs, pools, character.mesh, this.skin, layout);
    this.surfaces = surfacesOf(character);
    this.createDress = (Dress) => new Dress(gpu, pools, character, onImage);
    this.onImage = onImage;
  }

  get state(): Actor {
    return this.evaluation.state;
  }

  get display(): DisplayTransform {
    return this.evaluation.display;
  }

  /** A sphere around the character as it is posed and placed. */
  get subject(): Subject {
    const { revision } = this;
    if (this.enclosed?.revision !== revision) {
      this.enclosed = { revision, subject: subjectOf([this.evaluation]) };
    }
    return this.enclosed.subject;
  }

  get characterFromJoint(): Float64Array {
    return this.evaluation.characterFromJoint;
  }

  /**
   * This changes with the posed vertices, the joints and the placement, so that whatever derives
   * from them can be updated.
   */
  get revision(): string {
    return `${this.shownVertices}.${this.evaluation.revisions.display}`;
  }

  /** Settles when the pictures of all surfaces are decoded and, where possible, are in textures. */
  async dressed(): Promise<void> {
    await this.dressing;
    await this.dress?.loaded;
  }

  /** Follows the actor's look. */
  wear(): void {
    const { state } = this;
    if (!this.dress && needsDress(state)) {
      const Dress = dressCode.value;
      if (Dress) this.dress = this.createDress(Dress);
      else this.dressing ??= this.fetchDress();
    }
    this.dress?.wear(state.look);
  }

  /**
   * Fills the posed buffers if the evaluation or the device changed, and otherwise does nothing.
   */
  update(device: SkinDevice): void {
    const { evaluation } = this;
    const { rest, vertices, normals } = evaluation.revisions;
    if (this.shownNormals === normals && this.shownDevice === device) return;
    const begin = performance.now();
    if (this.skin !== evaluation.skin) {
      this.skin = evaluation.skin;
      this.skinned.useSkin(this.skin);
    }
    if (this.shownRest !== rest) this.skinned.writeRest(evaluation.rest);
    const { method, palette, use } = evaluation;
    const isOnGpu = device === 'gpu' && !method.finish;
    if (isOnGpu) this.skinned.skinOnGpu(method, palette, use);
    else this.skinned.upload(evaluation.vertices());
    // A gather on the GPU would need a second stage for what the CPU does in two milliseconds.
    if (isOnGpu && normals !== vertices) {
      this.skinned.uploadNormals(evaluation.vertices());
    }
    this.shownRest = rest;
    this.shownVertices = vertices;
    this.shownNormals = normals;
    this.shownDevice = device;
    this.poseMilliseconds = performance.now() - begin;
  }

  /** Draws what casts shadows, which is everything visible, with a program that is in use. */
  drawCaster(program: Program): void {
    program.set({ sceneFromCharacter: this.display.sceneFromCharacter });
    for (const { submesh, alpha } of this.surfaces) {
      if (alpha === 1) this.skinned.drawSolid(program, submesh);
      else if (alpha > 0) this.skinned.draw(program, submesh);
    }
  }

  dispose(): void {
    this.isDisposed = true;
    this.skinned.dispose();
    this.dress?.dispose();
  }

  private async fetchDress(): Promise<void> {
    const { name } = this.state.character;
    try {
      await dressCode.load();
      if (this.isDisposed) return;
      this.wear();
      this.onImage(name, null);
    } catch (error) {
      this.onImage(name, (error as Error).message);
    }
  }
}
