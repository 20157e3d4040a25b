import { mat4, vec4 } from 'gl-matrix';

/**
 * The loop of the assignment: every weight of a vertex's row, zeros too, moves the point by its
 * joint's matrix.
 *
 * @param matrices (columnCount × 16) characterFromJoint · jointFromBind of each column
 * @param rows (vertexCount × columnCount) weights
 */
export function glMatrixSkinning(restPositions, matrices, rows) {
  const columnCount = matrices.length / 16;
  const moves = Array.from({ length: columnCount }, (_, column) =>
    mat4.clone(matrices.subarray(column * 16, column * 16 + 16)),
  );
  const positions = new Float32Array(restPositions.length);
  const point = vec4.create();
  const moved = vec4.create();
  const sum = vec4.create();
  return {
    positions,
    run() {
      for (let i = 0; 3 * i < positions.length; i++) {
        const at = 3 * i;
        vec4.set(point, restPositions[at], restPositions[at + 1], restPositions[at + 2], 1);
        vec4.zero(sum);
        for (let column = 0; column < columnCount; column++) {
          vec4.transformMat4(moved, point, moves[column]);
          vec4.scaleAndAdd(sum, sum, moved, rows[i * columnCount + column]);
        }
        positions[at] = sum[0];
        positions[at + 1] = sum[1];
        positions[at + 2] = sum[2];
      }
    },
  };
}
