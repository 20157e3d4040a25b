import { vec3 } from 'gl-matrix';
import type { Submesh } from '../../core/mesh.ts';
import type { ActorLook } from '../../document/actor-look.ts';
import type { Program } from '../../gl/program.ts';
import type { Defines } from '../../gl/shader-library.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { polishOf } from '../polish.ts';
import { palette } from '../theme.ts';

/** The opacity of a translucent skin over what is behind it. */
const translucentOpacity = 0.42;

const textureUnit = 4;
const white = [1, 1, 1];
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
  isMirrored: true,
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
        else if (cover)
          view.skinned.draw(program, submesh); // it may have holes
        else drawOpaque(frame, view, program, submesh);
      }
    }

    /** From inside a closed surface, its inner side is all that is visible. */
    function drawOpaque(
      { eye, near }: Frame,
      { skinned, subject }: CharacterView,
      program: Program,
      submesh: Submesh,
    ): void {
      const isOutside = vec3.distance(eye, subject.center) > subject.radius + near;
      if (isOutside) skinned.drawSolid(program, submesh);
      else skinned.draw(program, submesh);
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
