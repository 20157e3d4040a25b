import type { Bounds } from '../core/bounds.ts';
import { forwardKinematics } from '../core/forward-kinematics.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import type { Skin } from '../core/skin.ts';
import { type Actor, boundClip, skinInUse } from '../document/scene.ts';
import { poseLayers } from '../posing/layers.ts';
import type { SkinningMethod, VertexStreams } from '../skinning/method.ts';
import { kernelOf } from '../skinning/registry.ts';
import { restKey, restMesh } from '../skinning/rest-mesh.ts';
import { type DisplayTransform, displayTransform } from './display-transform.ts';
import type { Evaluation, Revisions } from './evaluation.ts';
import { posedBounds } from './posed-bounds.ts';
import { Stage } from './stage.ts';

/** Evaluates one character at one moment after another; belongs to whoever looks. */
export class Evaluator implements Evaluation {
  private now: Actor;
  private time = 0;
  private readonly layered: Float64Array;
  private readonly joints: Float64Array;
  private packed = new Float32Array(0);
  private posed: VertexStreams | null = null;

  private readonly valueStage: Stage<Float64Array>;
  private readonly jointStage: Stage<Float64Array>;
  private readonly restStage: Stage<Mesh>;
  private readonly paletteStage: Stage<Float32Array>;
  private readonly vertexStage: Stage<VertexStreams>;
  private readonly boundsStage: Stage<Bounds>;
  private readonly displayStage: Stage<DisplayTransform>;

  constructor(state: Actor) {
    this.now = state;
    const { character } = state;
    const { skeleton } = character;
    this.layered = new Float64Array(skeleton.qRest.length);
    this.joints = new Float64Array(skeleton.jointCount * 16);
    this.valueStage = new Stage(
      () => [this.now.q, this.now.clips, this.now.clip, this.isStill ? 0 : this.time],
      () => this.applyLayers(),
    );
    this.jointStage = new Stage(
      () => [this.valueStage.revision],
      () => {
        forwardKinematics(skeleton, this.valueStage.value, this.joints);
        return this.joints;
      },
    );
    this.restStage = new Stage(
      () => restKey(character, this.pose),
      () => restMesh(character, this.pose),
    );
    this.paletteStage = new Stage(
      () => [this.jointStage.revision, this.skin, this.method],
      () => this.pack(),
    );
    this.vertexStage = new Stage(
      () => [this.paletteStage.revision, this.restStage.revision],
      () => this.deform(),
    );
    this.boundsStage = new Stage(
      () => [this.vertexStage.revision],
      () => posedBounds(character, this.vertices().positions, this.characterFromJoint),
    );
    this.displayStage = new Stage(
      () => [this.now.transform],
      () => displayTransform(character, this.now.transform),
    );
  }

  /** Whether a state can be evaluated here: it is of the same character. */
  fits({ id, character }: Actor): boolean {
    return id === this.now.id && character === this.now.character;
  }

  /** @param time seconds of the bound clip */
  evaluate(state: Actor, time: number): Evaluation {
    this.now = state;
    this.time = time;
    return this;
  }

  get state(): Actor {
    return this.now;
  }

  get pose(): Required<Pose> {
    return { q: this.valueStage.value, morphWeights: this.now.morphWeights };
  }

  get characterFromJoint(): Float64Array {
    return this.jointStage.value;
  }

  get rest(): Mesh {
    return this.restStage.value;
  }

  get skin(): Skin {
    return skinInUse(this.now);
  }

  get method(): SkinningMethod {
    return kernelOf(this.now);
  }

  get palette(): Float32Array {
    return this.paletteStage.value;
  }

  get display(): DisplayTransform {
    return this.displayStage.value;
  }

  get revisions(): Revisions {
    return {
      pose: this.jointStage.revision,
      rest: this.restStage.revision,
      palette: this.paletteStage.revision,
      vertices: this.vertexStage.revision,
      display: this.displayStage.revision,
    };
  }

  vertices(): VertexStreams {
    return this.vertexStage.value;
  }

  bounds(): Bounds {
    return this.boundsStage.value;
  }

  snapshot(): Pose {
    const { q, morphWeights } = this.pose;
    return { q: q.slice(), morphWeights: morphWeights.slice() };
  }

  /** Whether no time passes for it. */
  private get isStill(): boolean {
    return this.now.clip === null;
  }

  /** The state's own values where no layer is active; else the same array is written again. */
  private applyLayers(): Float64Array {
    const { q } = this.now;
    const context = { clip: boundClip(this.now) ?? null, time: this.time };
    if (!poseLayers.some((layer) => layer.isActive(context))) return q;
    this.layered.set(q);
    for (const layer of poseLayers) {
      if (layer.isActive(context)) layer.apply(context, this.layered);
    }
    return this.layered;
  }

  private pack(): Float32Array {
    const { skin, method } = this;
    const length = skin.paletteJoint.length * method.vec4sPerEntry * 4;
    if (this.packed.length !== length) this.packed = new Float32Array(length);
    method.packPalette(skin, this.characterFromJoint, this.packed);
    return this.packed;
  }

  private deform(): VertexStreams {
    const { rest, skin, palette, method } = this;
    this.posed ??= {
      positions: new Float32Array(rest.vertexCount * 3),
      normals: new Float32Array(rest.vertexCount * 3),
    };
    method.deform(rest, skin, palette, this.posed);
    return this.posed;
  }
}
