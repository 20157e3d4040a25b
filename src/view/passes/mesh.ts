import type { MaterialParts } from '../../core/character-parts.ts';
import { baseName } from '../../formats/file-entry.ts';
import type { Program } from '../../gl/program.ts';
import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';

/** How much of what is behind a translucent skin it hides. */
const translucentOpacity = 0.42;

const textureUnit = 4;
const white = [1, 1, 1];

/**
 * The posed skin, matte, smooth or faceted, with the textures of its materials. A translucent one is
 * drawn to depth first, so that of all its layers only the nearest is blended over what is behind.
 */
export const meshPass: Pass = {
  id: 'mesh',
  create({ gl }, programs) {
    return {
      draw(frame) {
        const { showSkin, translucent } = frame.options;
        if (!showSkin) return;
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
      const program = programs.pass('mesh');
      program.use();
      program.set(frame.uniforms);
      program.set({ faceted: frame.options.faceted, opacity, colorTexture: textureUnit });
      for (const view of frame.characters) {
        program.set({ sceneFromCharacter: view.display.sceneFromCharacter });
        drawSubmeshes(program, view, frame.options.showTextures);
      }
    }
  },
};

function drawSubmeshes(program: Program, view: CharacterView, showTextures: boolean): void {
  const { materials } = view.state.character;
  const dressed = showTextures ? view.skinned.mesh.submeshes : [];
  if (!dressed.some(({ material }) => textureOf(materialOf(material)))) {
    program.set({ albedo: palette.clay, textured: false });
    view.skinned.draw(program);
    return;
  }
  for (const submesh of dressed) {
    const texture = textureOf(materialOf(submesh.material));
    texture?.bind(textureUnit);
    program.set({ albedo: texture ? white : palette.clay, textured: texture !== undefined });
    view.skinned.draw(program, submesh);
  }

  function materialOf(name: string): MaterialParts | undefined {
    return materials.find((each) => each.name === name);
  }

  function textureOf(material: MaterialParts | undefined) {
    const name = material?.texture;
    return name === undefined ? undefined : view.textures.find(baseName(name));
  }
}
