import type { Pass } from '../pass.ts';

const halfSize = 24;

/**
 * Draws a floor of large soft checks that fades into the backdrop, with the characters' shadow on
 * it.
 */
export const floorPass: Pass = {
  id: 'floor',
  isShown: ({ showStudio }) => showStudio,
  create({ gl }, programs) {
    return {
      draw({ theme, uniforms }) {
        const program = programs.pass('floor');
        program.use();
        program.set(uniforms);
        program.set({
          halfSize,
          floorLight: theme.floorLight,
          floorDark: theme.floorDark,
          checkSize: 0.5,
          fadeStart: 0.8,
          fadeEnd: 5,
          shadowStrength: theme.shadowStrength,
        });
        gl.bindVertexArray(null);
        gl.enable(gl.CULL_FACE); // the floor is invisible from below
        gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
        gl.disable(gl.CULL_FACE);
      },
      dispose: () => undefined,
    };
  },
};
