import { mat4, vec3 } from 'gl-matrix';
import { clippedBehind, planarMirror } from '../../core/planar.ts';
import type { Frame } from '../frame.ts';
import { MirrorPicture } from '../mirror-picture.ts';
import type { Pass } from '../pass.ts';
import { floorDefines, floorPlane, floorUniforms, hasFloor } from './floor.ts';

const mirrorUnit = 5;
/** Turns a picture upside down, in clip space. */
const upsideDown = Float64Array.of(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

/**
 * Draws what the floor mirrors over it, more the flatter one looks at it. The mirrored scene is a
 * picture of its own, which other passes draw as the eye's mirror image sees it.
 */
export const reflectionPass: Pass = {
  id: 'reflection',
  isShown: (options) => hasFloor(options) && options.environment.floor.reflection > 0,
  create(gpu, programs) {
    const { gl } = gpu;
    const picture = new MirrorPicture(gpu, mirrorUnit);
    const isSeen = ({ eye }: Frame): boolean => eye[1] > 0;
    return {
      prepare(frame, drawMirrored) {
        if (isSeen(frame)) picture.draw(frame, () => drawMirrored(mirrored(frame)));
      },
      draw(frame) {
        if (!isSeen(frame)) return;
        const program = programs.pass('reflection', floorDefines(frame));
        program.use();
        program.set(frame.uniforms);
        program.set(floorUniforms(frame));
        picture.bind();
        program.set({
          mirrored: mirrorUnit,
          reflection: frame.options.environment.floor.reflection,
        });
        gl.bindVertexArray(null);
        // The floor is there already, and nothing else.
        gl.disable(gl.DEPTH_TEST);
        gl.enable(gl.CULL_FACE);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.DST_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
        gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
        gl.disable(gl.BLEND);
        gl.disable(gl.CULL_FACE);
        gl.enable(gl.DEPTH_TEST);
      },
      dispose: () => picture.dispose(),
    };
  },
};

/**
 * Returns the frame of the eye's mirror image, which sees what is above the floor from below. Places
 * and lights of the scene stay as they are. The picture is upside down, so that front faces stay
 * front faces.
 */
function mirrored(frame: Frame): Frame {
  const mirror = planarMirror(floorPlane);
  const flipped = mat4.multiply(new Float64Array(16), upsideDown, frame.clipFromScene);
  const clipFromScene = clippedBehind(mat4.multiply(flipped, flipped, mirror), floorPlane);
  const eye = vec3.transformMat4(new Float64Array(3), frame.eye, mirror);
  const uniforms = { ...frame.uniforms, clipFromScene: Float32Array.from(clipFromScene), eye };
  return { ...frame, clipFromScene, eye, uniforms };
}
