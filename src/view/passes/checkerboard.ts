import type { Pass } from '../pass.ts';

/**
 * Draws checks behind everything that is not opaque, where the background is transparent. They are
 * for the page; a picture stays transparent there.
 */
export const checkerboardPass: Pass = {
  id: 'checkerboard',
  isShown: ({ environment, showOverlay }) =>
    showOverlay && environment.background.kind === 'transparent',
  create({ gl }, programs) {
    return {
      draw(frame) {
        const program = programs.pass('checkerboard');
        program.use();
        program.set(frame.uniforms);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.ONE_MINUS_DST_ALPHA, gl.ONE);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.BLEND);
        gl.enable(gl.DEPTH_TEST);
      },
      dispose: () => undefined,
    };
  },
};
