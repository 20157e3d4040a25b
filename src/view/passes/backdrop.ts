import type { Pass } from '../pass.ts';

/** The studio's gradient, behind everything. */
export const backdropPass: Pass = {
  id: 'backdrop',
  create({ gl }, programs) {
    return {
      draw(frame) {
        if (!frame.options.showStudio) return;
        const program = programs.pass('backdrop');
        program.use();
        program.set(frame.uniforms);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.enable(gl.DEPTH_TEST);
      },
      dispose: () => undefined,
    };
  },
};
