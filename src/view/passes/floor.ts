import type { Pass } from '../pass.ts';

/** The distances from the scene's origin between which the floor fades into the backdrop. */
const [fadeStart, fadeEnd] = [0.8, 5];

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
          // Past this the floor looks like the backdrop, which is drawn there.
          halfSize: fadeEnd,
          floorLight: theme.floorLight,
          floorDark: theme.floorDark,
          checkSize: 0.5,
          fadeStart,
          fadeEnd,
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
