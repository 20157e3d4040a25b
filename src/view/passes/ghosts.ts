import type { ReadonlySignal } from '@preact/signals-core';
import type { CharacterView } from '../character-view.ts';
import { drawOpaque } from '../draw-skin.ts';
import type { Frame } from '../frame.ts';
import { GhostSolids } from '../ghost-solids.ts';
import type { Ghost } from '../ghosts.ts';
import type { Pass } from '../pass.ts';
import type { Viewer } from '../viewer.ts';
import { floorPass, hasFloor } from './floor.ts';

/** Ghosts have no highlights. */
const matte = { specular: [0, 0, 0], shininess: 0 };

/**
 * Draws ghosts, each in one color, behind everything but the floor, so that they never cover the
 * character itself. Only the nearest layer of each is blended, so that it looks like a pale copy and
 * not like the inside of a body.
 */
export function ghostsPass(viewer: Viewer, shown: ReadonlySignal<readonly Ghost[]>): Pass {
  return {
    id: 'ghosts',
    isShown: ({ showOverlay }) => showOverlay && shown.value.length > 0,
    create(gpu, programs) {
      const { gl } = gpu;
      const program = programs.pass('mesh');
      const floor = floorPass.create(gpu, programs);
      let solids: GhostSolids | null = null;
      return {
        draw(frame) {
          const ghosts = shown.peek();
          const views = viewer.present().viewsOf(ghosts.map(({ evaluation }) => evaluation));
          gl.depthFunc(gl.LEQUAL);
          gl.blendFuncSeparate(
            gl.SRC_ALPHA,
            gl.ONE_MINUS_SRC_ALPHA,
            gl.ONE,
            gl.ONE_MINUS_SRC_ALPHA,
          );
          for (const { evaluation, color, opacity } of ghosts) {
            const view = views.find((each) => each.evaluation === evaluation);
            if (!view) continue;
            const draw = drawerOf(frame, view, color, opacity);
            gl.colorMask(false, false, false, false);
            draw();
            gl.colorMask(true, true, true, true);
            gl.depthFunc(gl.EQUAL);
            gl.enable(gl.BLEND);
            draw();
            gl.disable(gl.BLEND);
            gl.depthFunc(gl.LEQUAL);
          }
          gl.depthFunc(gl.LESS);
          gl.clear(gl.DEPTH_BUFFER_BIT);
          if (hasFloor(frame.options)) drawFloorDepth(frame);
        },
        dispose() {
          floor.dispose();
          solids?.dispose();
        },
      };

      function drawFloorDepth(frame: Frame): void {
        gl.colorMask(false, false, false, false);
        floor.draw(frame);
        gl.colorMask(true, true, true, true);
      }

      /** A ghost is of what the view shows of the character: its skin, or else its bones. */
      function drawerOf(
        frame: Frame,
        view: CharacterView,
        color: readonly number[],
        opacity: number,
      ): () => void {
        if (!frame.options.showSkin || view.surfaces.length === 0) {
          const bones = (solids ??= new GhostSolids(gpu, programs));
          bones.show(view, frame, color);
          return () => bones.draw(frame, opacity);
        }
        program.use();
        program.set(frame.uniforms);
        program.set(matte);
        program.set({ albedo: color, opacity });
        return () => drawSkin(frame, view);
      }

      function drawSkin(frame: Frame, view: CharacterView): void {
        program.set({ sceneFromCharacter: view.display.sceneFromCharacter });
        for (const { submesh, alpha } of view.surfaces) {
          if (alpha > 0.5) drawOpaque(frame, view, program, submesh);
        }
      }
    },
  };
}
