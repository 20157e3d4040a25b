import { mat4, type ReadonlyMat4 } from 'gl-matrix';
import { assert } from './assert.ts';

/**
 * The matrix stack of the 6.837 handout, part 3.1. It is the identity when empty, and a pushed
 * matrix is multiplied by the one below it, so that the top always maps the innermost space to the
 * outermost. Levels are reused, so that nothing is allocated after the first traversal.
 */
export class MatrixStack {
  private readonly levels: Float64Array[] = [];
  private size = 0;

  get depth(): number {
    return this.size;
  }

  /**
   * The product of all pushed matrices, column-major, float64; valid until the next push or pop.
   */
  get top(): ReadonlyMat4 {
    return this.size === 0 ? identity : this.levels[this.size - 1]!;
  }

  push(matrix: ReadonlyMat4): void {
    let level = this.levels[this.size];
    if (!level) this.levels.push((level = new Float64Array(16)));
    mat4.multiply(level, this.top, matrix);
    this.size++;
  }

  pop(): void {
    assert(this.size > 0, 'pop of an empty matrix stack');
    this.size--;
  }

  popTo(depth: number): void {
    assert(depth >= 0 && depth <= this.size, 'a depth that the matrix stack has');
    this.size = depth;
  }
}

const identity: ReadonlyMat4 = mat4.identity(new Float64Array(16));
