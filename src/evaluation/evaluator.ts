import type { Bounds } from '../core/bounds.ts';
import { forwardKinematics } from '../core/forward-kinematics.ts';
import type { FaceWeighting } from '../core/vertex-normals.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pose } from '../core/pose.ts';
import type { Skin } from '../core/skin.ts';
import { type Actor, boundClip, skinInUse } from '../document/scene.ts';
import { poseLayers } from '../posing/layers.ts';
import type { Pin } from '../posing/pins/pin.ts';
import type { LayerFunction } from '../posing/pose-layer.ts';
import { linearBlend } from '../skinning/linear-blend.ts';
import type { MethodUse, SkinningMethod, VertexStreams } from '../skinning/method.ts';
import { poseVertices } from '../skinning/pose-vertices.ts';
import { normalWays, recomputedNormals } from '../skinning/registry.ts';
import { restKey, restMesh } from '../skinning/rest-mesh.ts';
import { type DisplayTransform, displayTransform } from './display-transform.ts';
import type { Evaluation, Revisions, StillEvaluation } from './evaluation.ts';
import { EvaluationPool, type ShownValues } from './evaluation-pool.ts';
import type { Kernels } from './kernels.ts';
import { posedBounds } from './posed-bounds.ts';
import { Stage } from './stage.ts';

/**
 * Evaluates one character at one moment after another. Whoever creates it disposes of it. It reuses
 * what other evaluators of its pool have computed from equal inputs.
 */
export class Evaluator implements Evaluation {
  private readonly pool: EvaluationPool;
  private readonly kernels: Kernels;
  private now: Actor;
  private time = 0;
  followed: Float64Array | null = null;

  private readonly valueStage: Stage<ShownValues>;
  private readonly jointStage: Stage<Float64Array>;
  private readonly restStage: Stage<Mesh>;
  private readonly paletteStage: Stage<Float32Array>;
  private readonly vertexStage: Stage<VertexStreams>;
  private readonly recomputedStage: Stage<VertexStreams>;
  private readonly boundsStage: Stage<Bounds>;
  private readonly displayStage: Stage<DisplayTransform>;

  constructor(state: Actor, pool = new EvaluationPool()) {
    this.now = state;
    this.pool = pool;
    this.kernels = pool.kernels;
    const { character } = state;
    const { skeleton } = character;
    const shared = pool.of(character);
    this.valueStage = new Stage(
      shared.values,
      () => [
        this.now.q,
        boundClip(this.now),
        this.isStill ? 0 : this.time,
        this.now.pins,
        this.now.natures,
        this.now.unkeyed,
        this.isStill ? null : this.now.morphWeights,
        this.followed,
        ...this.layers,
      ],
      (former) => this.applyLayers(former?.written ?? []),
    );
    this.jointStage = new Stage(
      shared.joints,
      () => [this.valueStage.revision],
      (joints = new Float64Array(skeleton.jointCount * 16)) => {
        forwardKinematics(skeleton, this.pose.q, joints);
        return joints;
      },
    );
    this.restStage = new Stage(
      shared.rest,
      () => restKey(character, this.pose),
      () => restMesh(character, this.pose),
    );
    this.paletteStage = new Stage(
      shared.palette,
      () => [this.jointStage.revision, this.skin, this.method],
      (former) => this.pack(former),
    );
    this.vertexStage = new Stage(
      shared.vertices,
      () => [
        this.paletteStage.revision,
        this.restStage.revision,
        this.now.methodSettings,
        this.use.extra,
      ],
      (former) => this.deform(former),
    );
    this.recomputedStage = new Stage(
      shared.recomputed,
      () => [this.vertexStage.revision, this.weighting],
      (former) => this.recompute(former),
    );
    this.boundsStage = new Stage(
      shared.bounds,
      () => [this.vertexStage.revision],
      () => posedBounds(character, this.vertexStage.value.positions, this.characterFromJoint),
    );
    this.displayStage = new Stage(
      shared.display,
      () => [this.now.transform, this.now.fitted],
      () => displayTransform(character, this.now),
    );
  }

  /** Whether a state can be evaluated here, which needs the same character. */
  fits({ id, character }: Actor): boolean {
    return id === this.now.id && character === this.now.character;
  }

  /**
   * @param time in seconds of the bound clip
   * @param followed see `PoseContext`; it is never written into
   */
  evaluate(state: Actor, time: number, followed: Float64Array | null = null): Evaluation {
    this.now = state;
    this.time = time;
    this.followed = followed;
    return this;
  }

  get state(): Actor {
    return this.now;
  }

  get pose(): Required<Pose> {
    return { q: this.valueStage.value.q, morphWeights: this.morphWeights };
  }

  get poseToEdit(): Required<Pose> {
    return { q: this.valueStage.value.toEdit, morphWeights: this.morphWeights };
  }

  get pins(): readonly Pin[] {
    return this.valueStage.value.pins;
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
    return this.kernels.readyFor(this.now) ?? linearBlend;
  }

  get use(): MethodUse {
    return {
      extra: this.kernels.extraOf(this.method, this.now),
      settings: this.now.methodSettings,
    };
  }

  get pending(): readonly string[] {
    const pending = [...this.kernels.pendingFor(this.now)];
    if (recomputedNormals(this.now.normals) && this.kernels.recompute.isPending) {
      pending.push(normalWays.find((way) => way.id === this.now.normals)!.label);
    }
    for (const layer of poseLayers) {
      if (layer.isActive(this.now) && this.kernels.layer(layer).isPending)
        pending.push(layer.label);
    }
    return pending;
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
      normals: this.shownVertices.revision,
      display: this.displayStage.revision,
    };
  }

  vertices(): VertexStreams {
    return this.shownVertices.value;
  }

  bounds(): Bounds {
    return this.boundsStage.value;
  }

  snapshot(): Required<Pose> {
    const { q, morphWeights } = this.poseToEdit;
    return { q: q.slice(), morphWeights: morphWeights.slice() };
  }

  still(): StillEvaluation {
    const still = new Evaluator(this.now, this.pool);
    still.evaluate(this.now, this.time, this.followed);
    return still;
  }

  /** Releases everything that it holds in its pool. */
  dispose(): void {
    for (const part of Object.values(this)) if (part instanceof Stage) part.release();
  }

  /** Only clips change them, so that without one the weights do not belong to the stage. */
  private get morphWeights(): Float64Array {
    return this.isStill ? this.now.morphWeights : this.valueStage.value.morphWeights;
  }

  /** Whether the actor has no clip, so that time does not change it. */
  private get isStill(): boolean {
    return this.now.clip === null;
  }

  /** How normals are recomputed, as soon as the code for it is there; otherwise null. */
  private get weighting(): FaceWeighting | null {
    const weighting = recomputedNormals(this.now.normals);
    return weighting && this.kernels.recompute.value ? weighting : null;
  }

  private get shownVertices(): Stage<VertexStreams> {
    return this.weighting ? this.recomputedStage : this.vertexStage;
  }

  /** The functions of the layers that are active and loaded, or undefined, in their order. */
  private get layers(): readonly (LayerFunction | undefined)[] {
    return poseLayers.map((layer) =>
      layer.isActive(this.now) ? this.kernels.layer(layer).value : undefined,
    );
  }

  /** Returns the state's own values if no layer changes them; otherwise it writes into arrays. */
  private applyLayers(written: Float64Array[]): ShownValues {
    const { q, morphWeights, pins } = this.now;
    const context = {
      ...this.now,
      clip: boundClip(this.now) ?? null,
      time: this.time,
      followed: this.followed,
    };
    const pose = { q, toEdit: q, morphWeights, pins, written };
    this.layers.forEach((apply, i) => {
      if (!apply) return;
      const values = (written[i] ??= new Float64Array(q.length));
      values.set(pose.q);
      pose.q = values;
      apply(context, pose);
      if (!poseLayers[i]!.isShownOnly) pose.toEdit = pose.q;
    });
    return pose;
  }

  private pack(former: Float32Array | undefined): Float32Array {
    const { skin, method } = this;
    const length = skin.paletteJoint.length * method.vec4sPerEntry(skin) * 4;
    const palette = former?.length === length ? former : new Float32Array(length);
    method.packPalette(skin, this.characterFromJoint, palette);
    return palette;
  }

  private deform(former: VertexStreams | undefined): VertexStreams {
    const { rest, skin, palette, method, use } = this;
    const posed = former ?? {
      positions: new Float32Array(rest.vertexCount * 3),
      normals: new Float32Array(rest.vertexCount * 3),
    };
    const { mesh } = this.now.character;
    poseVertices(method, mesh, rest, skin, palette, use, posed, this.kernels.wasm);
    return posed;
  }

  /** The positions are those of the skin. */
  private recompute(former: VertexStreams | undefined): VertexStreams {
    const { positions } = this.vertexStage.value;
    const posed = { positions, normals: former?.normals ?? new Float32Array(positions.length) };
    this.kernels.recompute.value!(this.now.character, this.weighting!, posed);
    return posed;
  }
}
