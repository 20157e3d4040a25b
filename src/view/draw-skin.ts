import { vec3 } from 'gl-matrix';
import type { Submesh } from '../core/mesh.ts';
import type { Program } from '../gl/program.ts';
import type { CharacterView } from './character-view.ts';
import type { Frame } from './frame.ts';

/** The opacity of a translucent skin over what is behind it. */
const translucentOpacity = 0.42;

/**
 * Draws skins over what is there. A translucent skin is drawn to depth first, so that only the
 * nearest of its layers is blended.
 *
 * @param draw draws all skins with an opacity
 */
export function blendSkins(
  gl: WebGL2RenderingContext,
  { options: { translucent } }: Frame,
  draw: (opacity: number) => void,
): void {
  gl.depthFunc(gl.LEQUAL);
  if (translucent) {
    gl.colorMask(false, false, false, false);
    draw(1);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.EQUAL);
  }
  gl.enable(gl.BLEND);
  gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  draw(translucent ? translucentOpacity : 1);
  gl.disable(gl.BLEND);
  gl.depthFunc(gl.LESS);
}

/** From inside a closed surface, its inner side is all that is visible. */
export function drawOpaque(
  { eye, near }: Frame,
  { skinned, subject }: CharacterView,
  program: Program,
  submesh: Submesh,
): void {
  const isOutside = vec3.distance(eye, subject.center) > subject.radius + near;
  if (isOutside) skinned.drawSolid(program, submesh);
  else skinned.draw(program, submesh);
}
