/** Lint rules of this project alone; .oxlintrc.json names them. */

/**
 * @typedef {{ type: string, parent?: Node, callee?: { name?: string } }} Node
 * @typedef {{ report: (finding: { node: unknown, message: string }) => void }} Context
 */

/** A part that a deploy removed from the server must become a failure with a message. */
const loadParts = {
  /** @param {Context} context */
  create: (context) => ({
    /** @param {Node} node */
    ImportExpression(node) {
      const call = node.parent;
      if (call?.type === 'CallExpression' && call.callee?.name === 'loadPart') return;
      context.report({ node, message: 'load it by loadPart of src/core/failure.ts' });
    },
  }),
};

export default { meta: { name: 'sinew' }, rules: { 'load-parts': loadParts } };
