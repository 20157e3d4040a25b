import type { Skin } from '../core/skin.ts';
import type { Character } from '../core/character.ts';
import type { CharacterState } from '../document/document.ts';
import type { SkinDevice } from '../document/session.ts';
import type { Evaluation } from '../evaluation/evaluation.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Program } from '../gl/program.ts';
import { type DisplayTransform, displayTransform } from './display-transform.ts';
import type { Programs } from './programs.ts';
import { type LayoutChoice, SkinnedMesh } from './skinned-mesh.ts';
import { type OnImage, SurfaceTextures } from './surface-textures.ts';
import { type Surface, surfacesOf } from './surfaces.ts';

/** A character of the document with its objects on the GPU, brought up to date on demand. */
export class CharacterView {
  readonly display: DisplayTransform;
  readonly skin: Skin;
  readonly skinned: SkinnedMesh;
  readonly surfaces: readonly Surface[];
  readonly textures: SurfaceTextures;
  private readonly character: Character;
  /** As last shown; brought up to date with the document before each picture. */
  evaluation: Evaluation;
  /** Milliseconds that the last change of pose took on the CPU. */
  poseMilliseconds = 0;
  private shownDevice: SkinDevice | null = null;
  private shownRest = 0;
  private shownVertices = 0;

  constructor(
    gpu: Gpu,
    programs: Programs,
    evaluation: Evaluation,
    onImage: OnImage,
    layout?: LayoutChoice,
  ) {
    const { character } = evaluation.state;
    this.evaluation = evaluation;
    this.skin = evaluation.skin;
    this.display = displayTransform(character);
    this.skinned = new SkinnedMesh(gpu, programs, character.mesh, this.skin, layout);
    this.surfaces = surfacesOf(character);
    this.textures = new SurfaceTextures(gpu, character, onImage);
    this.character = character;
  }

  get state(): CharacterState {
    return this.evaluation.state;
  }

  get characterFromJoint(): Float64Array {
    return this.evaluation.characterFromJoint;
  }

  /** Changes with posed vertices and joints, so that what derives from them can tell. */
  get revision(): number {
    return this.shownVertices;
  }

  /** Whether this view's buffers are those that the evaluation needs. */
  fits({ state: { character }, skin }: Evaluation): boolean {
    return character === this.character && skin === this.skin;
  }

  /** Fills the posed buffers where what is evaluated or the device changed; else does nothing. */
  update(device: SkinDevice): void {
    const { evaluation } = this;
    const { rest, vertices } = evaluation.revisions;
    if (this.shownVertices === vertices && this.shownDevice === device) return;
    const begin = performance.now();
    if (this.shownRest !== rest) this.skinned.writeRest(evaluation.rest);
    if (device === 'gpu') this.skinned.skinOnGpu(evaluation.method, evaluation.palette);
    else this.skinned.upload(evaluation.vertices());
    this.shownRest = rest;
    this.shownVertices = vertices;
    this.shownDevice = device;
    this.poseMilliseconds = performance.now() - begin;
  }

  /** Draws what throws shadows, with a program that is in use: all but what can't be seen. */
  drawCaster(program: Program): void {
    program.set({ sceneFromCharacter: this.display.sceneFromCharacter });
    for (const { submesh, alpha } of this.surfaces) {
      if (alpha > 0) this.skinned.draw(program, submesh);
    }
  }

  dispose(): void {
    this.skinned.dispose();
    this.textures.dispose();
  }
}
