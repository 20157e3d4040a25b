import type { Evaluation } from '../evaluation/evaluation.ts';
import { TriangleTree } from '../posing/triangle-tree.ts';
import type { VertexStreams } from '../skinning/method.ts';

/**
 * Returns the posed triangles of a character in a tree, which is refitted when it is requested in
 * another pose.
 */
export function posedTriangles(evaluation: Evaluation): TriangleTree {
  const posed = evaluation.vertices();
  const { vertices: revision } = evaluation.revisions;
  let fitted = trees.get(posed);
  if (!fitted) {
    fitted = { tree: new TriangleTree(evaluation.state.character.mesh), revision: 0 };
    trees.set(posed, fitted);
  }
  if (fitted.revision !== revision) fitted.tree.refit(posed.positions);
  fitted.revision = revision;
  return fitted.tree;
}

/**
 * The trees, keyed by the arrays that evaluations of one pose share, with the revision of their
 * content.
 */
const trees = new WeakMap<VertexStreams, { readonly tree: TriangleTree; revision: number }>();
