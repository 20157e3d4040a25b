import type { Submesh } from '../../core/mesh.ts';
import type { ActorLook } from '../../document/actor-look.ts';
import type { Program } from '../../gl/program.ts';
import type { Defines } from '../../gl/shader-library.ts';
import type { CharacterView } from '../character-view.ts';
import { blendSkins, drawOpaque } from '../draw-skin.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { polishOf } from '../polish.ts';
import { palette } from '../theme.ts';
import { showsWeights } from '../view-options.ts';

const textureUnit = 4;
const white = [1, 1, 1];
/** A surface with less opacity is invisible and must not hide anything. */
const leastOpacity = 0.002;

/**
 * Draws the posed skin, smooth or faceted, with the colors and textures of its materials, or as
 * clay. Surfaces are blended in the order of the file; of two at the same depth, the later one
 * wins. What shows its weights is left to another pass.
 */
export const meshPass: Pass = {
  id: 'mesh',
  isShown: ({ showSkin }) => showSkin,
  isMirrored: true,
  create({ gl }, programs) {
    return {
      draw(frame) {
        blendSkins(gl, frame, (opacity) => {
          for (const view of frame.characters) {
            if (!showsWeights(view.state.id, frame.options)) drawSurfaces(frame, view, opacity);
          }
        });
      },
      dispose: () => undefined,
    };

    function drawSurfaces(frame: Frame, view: CharacterView, opacity: number): void {
      const { surfaces } = view;
      const { look } = view.state;
      const { dress } = view;
      const defines = definesOf(look);
      const isDressed =
        frame.options.showTextures &&
        look.surface !== 'clay' &&
        surfaces.some(({ albedo, texture }) => albedo ?? dress?.coverOf(texture, look));
      if (!isDressed) {
        const program = programs.pass('mesh', defines);
        useProgram(program, frame, view);
        program.set({ albedo: palette.clays[look.clay]!, ...polishOf(look), opacity });
        for (const { submesh } of surfaces) drawOpaque(frame, view, program, submesh);
        return;
      }
      let used: Program | undefined;
      for (const { submesh, albedo, alpha, twoSided, texture, ...gloss } of surfaces) {
        if (alpha * opacity < leastOpacity) continue;
        const cover = dress?.coverOf(texture, look);
        const program = programs.pass(cover?.program ?? 'mesh', defines);
        if (program !== used) useProgram((used = program), frame, view);
        cover?.bind(textureUnit);
        program.set({
          albedo: albedo ?? (cover ? white : palette.clays[look.clay]!),
          ...gloss,
          ...cover?.uniforms,
          opacity: alpha * opacity,
        });
        if (alpha < 1) {
          // The inner side of a translucent surface is drawn before the outer one.
          drawSide(view, program, submesh, gl.FRONT);
          drawSide(view, program, submesh, gl.BACK);
        } else if (!twoSided) drawSide(view, program, submesh, gl.BACK);
        else if (cover) view.skinned.draw(program, submesh); // it may have holes
        else drawOpaque(frame, view, program, submesh);
      }
    }

    function drawSide(
      { skinned }: CharacterView,
      program: Program,
      submesh: Submesh,
      culled: number,
    ): void {
      gl.enable(gl.CULL_FACE);
      gl.cullFace(culled);
      skinned.draw(program, submesh);
      gl.cullFace(gl.BACK);
      gl.disable(gl.CULL_FACE);
    }
  },
};

/** The variant of a program. */
function definesOf({ shading }: ActorLook): Defines {
  return shading === 'faceted' ? { FACETED: 1 } : {};
}

function useProgram(program: Program, frame: Frame, view: CharacterView): void {
  program.use();
  program.set(frame.uniforms);
  program.set({
    colorTexture: textureUnit,
    sceneFromCharacter: view.display.sceneFromCharacter,
  });
}
