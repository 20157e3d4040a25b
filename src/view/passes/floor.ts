import { vec3 } from 'gl-matrix';
import type { Plane } from '../../core/planar.ts';
import type { UniformValue } from '../../gl/program.ts';
import type { Defines } from '../../gl/shader-library.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import type { ViewOptions } from '../view-options.ts';

/** The floor, which is lit from above. */
export const floorPlane: Plane = [0, 1, 0, 0];

/**
 * The distances from the scene's origin between which the floor fades into the backdrop, for scenes
 * that reach no farther than this from it; for others, everything grows.
 */
const [fadeStart, fadeEnd, usualReach] = [0.8, 5, 4];

/**
 * Draws a floor of large soft checks that fades into the backdrop, with the characters' mapped
 * shadow on it.
 */
export const floorPass: Pass = {
  id: 'floor',
  isShown: hasFloor,
  create({ gl }, programs) {
    return {
      draw(frame) {
        const program = programs.pass('floor', floorDefines(frame));
        program.use();
        program.set(frame.uniforms);
        program.set(floorUniforms(frame));
        gl.bindVertexArray(null);
        gl.enable(gl.CULL_FACE); // the floor is invisible from below
        gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
        gl.disable(gl.CULL_FACE);
      },
      dispose: () => undefined,
    };
  },
};

export function hasFloor({ environment, showSurroundings }: ViewOptions): boolean {
  return showSurroundings && environment.floor.kind !== 'off';
}

/** Without a background, the floor fades into nothing. */
export function floorDefines({ options: { environment } }: Frame): Defines {
  return environment.background.kind === 'transparent' ? { CUT_OUT: 1 } : {};
}

/** What shaders need to know of the floor's surface. */
export function floorUniforms({ characters, options, theme }: Frame): Record<string, UniformValue> {
  const reaches = characters.map(({ subject }) => vec3.length(subject.center) + subject.radius);
  const growth = Math.max(usualReach, ...reaches) / usualReach;
  const { floorLight, floorDark, shadowStrength } = theme;
  return {
    // Past this the floor looks like the backdrop, which is drawn there.
    halfSize: fadeEnd * growth,
    checkSize: 0.5,
    fadeStart: fadeStart * growth,
    fadeEnd: fadeEnd * growth,
    shadowDarkness: options.environment.shadow.darkness,
    floorLight,
    floorDark,
    shadowStrength,
  };
}
