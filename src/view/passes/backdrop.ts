import type { Defines } from '../../gl/shader-library.ts';
import type { Pass } from '../pass.ts';
import type { ViewOptions } from '../view-options.ts';

/** Draws the background where the floor does not hide it. */
export const backdropPass: Pass = {
  id: 'backdrop',
  isShown: (options) => options.showSurroundings && !backdropDefines(options)['CUT_OUT'],
  create({ gl }, programs) {
    return {
      draw(frame) {
        const program = programs.pass('backdrop', backdropDefines(frame.options));
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

/** A transparent background is empty in a picture; the page shows checks in its place. */
export function backdropDefines({ environment, showOverlay }: ViewOptions): Defines {
  if (environment.background.kind !== 'transparent') return {};
  return showOverlay ? { CHECKERED: 1 } : { CUT_OUT: 1 };
}
