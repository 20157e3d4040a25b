import type { Program } from '../../gl/program.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';

/** The opacity of a translucent skin over what is behind it. */
const translucentOpacity = 0.42;

const textureUnit = 4;
const white = [1, 1, 1];
const clay = { albedo: palette.clay, specular: [0, 0, 0] };
/** A surface with less opacity is invisible and must not hide anything. */
const leastOpacity = 0.002;

/**
 * Draws the posed skin, smooth or faceted, with the colors and textures of its materials, or as
 * clay. Surfaces are blended in the order of the file; of two at the same depth, the later one
 * wins. A translucent skin is drawn to depth first, so that only the nearest of its layers is
 * blended over what is behind it.
 */
export const meshPass: Pass = {
  id: 'mesh',
  isShown: ({ showSkin }) => showSkin,
  create({ gl }, programs) {
    return {
      draw(frame) {
        const { translucent } = frame.options;
        gl.depthFunc(gl.LEQUAL);
        if (translucent) {
          gl.colorMask(false, false, false, false);
          drawSkins(frame, 1);
          gl.colorMask(true, true, true, true);
          gl.depthFunc(gl.EQUAL);
        }
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        drawSkins(frame, translucent ? translucentOpacity : 1);
        gl.disable(gl.BLEND);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => undefined,
    };

    function drawSkins(frame: Frame, opacity: number): void {
      for (const view of frame.characters) drawSurfaces(frame, view, opacity);
    }

    function drawSurfaces(frame: Frame, view: CharacterView, opacity: number): void {
      const { surfaces, textures } = view;
      const isDressed = surfaces.some(({ albedo, texture }) => albedo ?? textures.find(texture));
      if (!frame.options.showTextures || !isDressed) {
        const program = programs.pass('mesh');
        useProgram(program, frame, view);
        program.set({ ...clay, opacity });
        view.skinned.draw(program);
        return;
      }
      let used: Program | undefined;
      for (const { submesh, albedo, alpha, twoSided, texture: name, ...gloss } of surfaces) {
        if (alpha * opacity < leastOpacity) continue;
        const texture = textures.find(name);
        const program = programs.pass(texture ? 'mesh-textured' : 'mesh');
        if (program !== used) useProgram((used = program), frame, view);
        texture?.bind(textureUnit);
        program.set({
          albedo: albedo ?? (texture ? white : palette.clay),
          ...gloss,
          opacity: alpha * opacity,
        });
        // The inner side of a translucent surface is drawn before the outer one.
        const culled = alpha < 1 ? [gl.FRONT, gl.BACK] : [twoSided ? gl.NONE : gl.BACK];
        for (const side of culled) {
          if (side !== gl.NONE) {
            gl.enable(gl.CULL_FACE);
            gl.cullFace(side);
          }
          view.skinned.draw(program, submesh);
          gl.disable(gl.CULL_FACE);
        }
      }
    }
  },
};

function useProgram(program: Program, frame: Frame, view: CharacterView): void {
  program.use();
  program.set(frame.uniforms);
  program.set({
    faceted: frame.options.faceted,
    colorTexture: textureUnit,
    sceneFromCharacter: view.display.sceneFromCharacter,
  });
}
