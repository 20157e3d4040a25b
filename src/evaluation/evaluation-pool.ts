import type { Bounds } from '../core/bounds.ts';
import type { Character } from '../core/character.ts';
import type { Mesh } from '../core/mesh.ts';
import type { Pin } from '../posing/pins/pin.ts';
import type { VertexStreams } from '../skinning/method.ts';
import type { DisplayTransform } from './display-transform.ts';
import { Kernels } from './kernels.ts';
import { StageCells } from './stage.ts';

/** What is shown after the pose layers, and the values of q from which edits start. */
export interface ShownValues {
  readonly q: Float64Array;
  readonly toEdit: Float64Array;
  readonly morphWeights: Float64Array;
  readonly pins: readonly Pin[];
  /** Arrays to write into, one for each layer that was active. */
  readonly written: Float64Array[];
}

/**
 * The cells that the evaluators of one character share. Each stage has one value for each pose that
 * is shown at the same time.
 */
class CharacterStages {
  readonly values = new StageCells<ShownValues>();
  readonly joints = new StageCells<Float64Array>();
  readonly rest = new StageCells<Mesh>();
  readonly palette = new StageCells<Float32Array>();
  readonly vertices = new StageCells<VertexStreams>();
  readonly recomputed = new StageCells<VertexStreams>();
  readonly bounds = new StageCells<Bounds>();
  readonly display = new StageCells<DisplayTransform>();

  /** The number of values that are held, over all stages. */
  get size(): number {
    const stages = Object.values(this) as StageCells<unknown>[];
    return stages.reduce((sum, { size }) => sum + size, 0);
  }
}

/**
 * Lets evaluators compute equal values only once, for copies in one pose or for one pose under two
 * methods. A value is dropped when the last evaluator that holds it moves on or is disposed.
 */
export class EvaluationPool {
  readonly kernels: Kernels;
  private readonly stages = new WeakMap<Character, CharacterStages>();

  constructor(kernels = new Kernels()) {
    this.kernels = kernels;
  }

  of(character: Character): CharacterStages {
    let found = this.stages.get(character);
    if (!found) this.stages.set(character, (found = new CharacterStages()));
    return found;
  }
}
