import type { Program } from '../../gl/program.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';

/** How much of what is behind a translucent skin it hides. */
const translucentOpacity = 0.42;

const textureUnit = 4;
const white = [1, 1, 1];
const clay = { albedo: palette.clay, specular: [0, 0, 0] };
/** What is less can't be seen, and hides nothing. */
const leastOpacity = 0.002;

/**
 * The posed skin, smooth or faceted, with the colors and textures of its materials, or as clay. It is
 * blended in the order of the file, and what comes later wins where two are as near. A translucent one
 * is drawn to depth first, so that of all its layers only the nearest is blended over what is behind.
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
        // Of what is seen through, the inner side comes before the outer one.
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
