import { forwardKinematics } from '../core/forward-kinematics.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Skin } from '../core/skin.ts';
import { type CharacterState, skinInUse } from '../document/document.ts';
import type { SkinDevice } from '../document/session.ts';
import { shownPose } from '../document/shown-pose.ts';
import type { Gpu } from '../gl/gpu.ts';
import type { Program } from '../gl/program.ts';
import type { VertexStreams } from '../skinning/method.ts';
import { methodById } from '../skinning/registry.ts';
import { restMesh } from '../skinning/rest-mesh.ts';
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
  /** (jointCount × 16) of the state last shown. */
  readonly worldFromJoint: Float64Array;
  state: CharacterState;
  /** Grows when posed vertices or joints change, so that what derives from them can tell. */
  version = 0;
  /** Milliseconds that the last change of pose took on the CPU. */
  poseMilliseconds = 0;
  private shownDevice: SkinDevice | null = null;
  private shown: CharacterState | null = null;
  private shownTime = 0;
  private rest: Mesh;
  private palette = new Float32Array(0);

  constructor(
    gpu: Gpu,
    programs: Programs,
    state: CharacterState,
    onImage: OnImage,
    layout?: LayoutChoice,
  ) {
    const { character } = state;
    this.state = state;
    this.rest = character.mesh;
    this.skin = skinInUse(state);
    this.display = displayTransform(character);
    this.skinned = new SkinnedMesh(gpu, programs, character.mesh, this.skin, layout);
    this.surfaces = surfacesOf(character);
    this.textures = new SurfaceTextures(gpu, character, onImage);
    this.worldFromJoint = new Float64Array(character.skeleton.jointCount * 16);
  }

  /** Whether this view's buffers are those that the state needs. */
  fits(state: CharacterState): boolean {
    return state.character === this.state.character && skinInUse(state) === this.skin;
  }

  /**
   * Fills the posed buffers where pose, method or device changed; else does nothing.
   * @param time seconds of the bound clip
   */
  update(device: SkinDevice, time: number): void {
    const { state } = this;
    const sameTime = state.clip === null || this.shownTime === time;
    if (this.shown === state && sameTime && this.shownDevice === device) return;
    const begin = performance.now();
    const { character, morphWeights } = state;
    const pose = shownPose(state, time);
    if (this.shown?.morphWeights !== morphWeights) {
      this.rest = restMesh(character, pose);
      this.skinned.writeRest(this.rest);
    }
    forwardKinematics(character.skeleton, pose.q, this.worldFromJoint);
    this.packPalette();
    if (device === 'gpu') this.skinned.skinOnGpu(methodById(state.method), this.palette);
    else this.skinned.upload(this.skinOnCpu());
    this.shown = state;
    this.shownTime = time;
    this.shownDevice = device;
    this.version++;
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

  private packPalette(): void {
    const method = methodById(this.state.method);
    const length = this.skin.paletteJoint.length * method.vec4sPerEntry * 4;
    if (this.palette.length !== length) this.palette = new Float32Array(length);
    method.packPalette(this.skin, this.worldFromJoint, this.palette);
  }

  private skinOnCpu(): VertexStreams {
    const { rest } = this;
    const out = {
      positions: new Float32Array(rest.vertexCount * 3),
      normals: new Float32Array(rest.vertexCount * 3),
    };
    methodById(this.state.method).deform(rest, this.skin, this.palette, out);
    return out;
  }
}
