import type { Pass } from '../pass.ts';

/** Draws the background where the floor does not hide it. */
export const backdropPass: Pass = {
  id: 'backdrop',
  isShown: ({ environment, showSurroundings }) =>
    showSurroundings && environment.background.kind !== 'transparent',
  create({ gl }, programs) {
    return {
      draw(frame) {
        const program = programs.pass('backdrop');
        program.use();
        program.set(frame.uniforms);
        gl.bindVertexArray(null);
        gl.depthFunc(gl.LEQUAL);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => undefined,
    };
  },
};
