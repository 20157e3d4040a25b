import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';

/** How much of what is behind a translucent skin it hides. */
const translucentOpacity = 0.42;

/**
 * The posed skin, matte, smooth or faceted. A translucent one is drawn to depth first, so that of all
 * its layers only the nearest is blended over what is behind.
 */
export const meshPass: Pass = {
  id: 'mesh',
  create({ gl }, programs) {
    return {
      draw(frame) {
        const { showSkin, translucent } = frame.options;
        if (!showSkin) return;
        if (!translucent) {
          drawSkins(frame, 1);
          return;
        }
        gl.colorMask(false, false, false, false);
        drawSkins(frame, 1);
        gl.colorMask(true, true, true, true);
        gl.depthFunc(gl.EQUAL);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        drawSkins(frame, translucentOpacity);
        gl.disable(gl.BLEND);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => undefined,
    };

    function drawSkins({ uniforms, options, characters }: Frame, opacity: number): void {
      const program = programs.pass('mesh');
      program.use();
      program.set(uniforms);
      program.set({ albedo: palette.clay, faceted: options.faceted, opacity });
      for (const { display, skinned } of characters) {
        program.set({ sceneFromCharacter: display.sceneFromCharacter });
        skinned.draw(program);
      }
    }
  },
};
