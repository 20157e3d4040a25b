import { planarShadow } from '../../core/planar.ts';
import { lightDirection } from '../light-direction.ts';
import type { Pass } from '../pass.ts';
import { floorDefines, floorPlane, floorUniforms, hasFloor } from './floor.ts';

/**
 * Draws the characters once more, pressed flat onto the floor along the key light, in the color that
 * the floor has in shadow. Where several of them overlap, the same color is drawn again, so that
 * every pixel is darkened once. It comes right after the floor, whose depth it keeps.
 */
export const planarShadowPass: Pass = {
  id: 'planar-shadow',
  isShown: (options) =>
    options.showSkin && hasFloor(options) && options.environment.shadow.kind === 'planar',
  create({ gl }, programs) {
    return {
      draw(frame) {
        const direction = lightDirection(frame.options.environment.lights[0]!);
        if (frame.eye[1] <= 0 || direction[1] <= 0) return;
        const program = programs.pass('planar-shadow', floorDefines(frame));
        program.use();
        program.set(frame.uniforms);
        program.set(floorUniforms(frame));
        program.set({ floorFromScene: planarShadow(floorPlane, [...direction, 0]) });
        gl.disable(gl.DEPTH_TEST);
        for (const view of frame.characters) view.drawCaster(program);
        gl.enable(gl.DEPTH_TEST);
      },
      dispose: () => undefined,
    };
  },
};
