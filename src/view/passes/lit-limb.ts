import type { CharacterView } from '../character-view.ts';
import type { Frame } from '../frame.ts';
import { gizmoOf } from '../gizmo.ts';
import type { Pass } from '../pass.ts';
import { palette } from '../theme.ts';
import { showsWeights, type ViewOptions } from '../view-options.ts';

/** A light on the skin of one joint: its strength on the face of the skin and at its outline. */
interface LimbLight {
  readonly actorId: number;
  readonly joint: number;
  readonly lightColor: readonly number[];
  readonly faceLight: number;
  readonly rimLight: number;
}

/** Lights the skin of the limb under the pointer, and outlines that of the selected joints. */
export const litLimbPass: Pass = {
  id: 'lit-limb',
  isShown: (options) => options.showOverlay && options.showSkin && lightsOf(options).length > 0,
  create({ gl }, programs) {
    return {
      draw(frame) {
        gl.depthMask(false);
        gl.depthFunc(gl.LEQUAL);
        // The skin lies at the same depth, which another program may round differently.
        gl.enable(gl.POLYGON_OFFSET_FILL);
        gl.polygonOffset(-1, -1);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        for (const light of lightsOf(frame.options)) {
          const view = frame.characters.find(({ state }) => state.id === light.actorId);
          if (view) drawLimb(frame, view, light);
        }
        gl.disable(gl.BLEND);
        gl.disable(gl.POLYGON_OFFSET_FILL);
        gl.depthMask(true);
        gl.depthFunc(gl.LESS);
      },
      dispose: () => undefined,
    };

    function drawLimb(frame: Frame, view: CharacterView, { joint, ...light }: LimbLight): void {
      const litEntry = view.evaluation.skin.paletteJoint.indexOf(joint);
      if (litEntry === -1) return;
      const { skinned, surfaces, display } = view;
      const program = programs.pass('lit-limb', { INFLUENCE_PAIRS: skinned.influencePairs });
      program.use();
      program.set(frame.uniforms);
      const { lightColor, faceLight, rimLight } = light;
      const { sceneFromCharacter } = display;
      program.set({ litEntry, lightColor, faceLight, rimLight, sceneFromCharacter });
      skinned.bindInfluences(program);
      for (const { submesh, alpha } of surfaces) {
        if (alpha > 0) skinned.drawSolid(program, submesh);
      }
    }
  },
};

function lightsOf(options: ViewOptions): LimbLight[] {
  const { hoveredLimb, selectedActorId } = options;
  const gizmo = gizmoOf(options);
  const lights: LimbLight[] = [];
  // Light would change the colors that stand for weights; their pass dims the other limbs instead.
  if (gizmo && selectedActorId !== null && !showsWeights(selectedActorId, options)) {
    for (const joint of options.selectedJoints) {
      const limb = { actorId: selectedActorId, joint };
      lights.push({ ...limb, lightColor: palette.selected, faceLight: 0.1, rimLight: 0.6 });
    }
    for (const joint of options.mirroredJoints) {
      const limb = { actorId: selectedActorId, joint };
      lights.push({ ...limb, lightColor: palette.selected, faceLight: 0.05, rimLight: 0.3 });
    }
  }
  if (hoveredLimb && !showsWeights(hoveredLimb.actorId, options)) {
    const { actorId, joint } = hoveredLimb;
    lights.push({ actorId, joint, lightColor: palette.hovered, faceLight: 0.22, rimLight: 0.4 });
  }
  return lights;
}
