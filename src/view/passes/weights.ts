import { truncationOf } from '../../evaluation/truncation.ts';
import type { Defines } from '../../gl/shader-library.ts';
import { jointColorsOf } from '../../skinning/weights/joint-colors.ts';
import { vertexColors, type WeightSubject } from '../../skinning/weights/views.ts';
import type { CharacterView } from '../character-view.ts';
import { blendSkins, drawOpaque } from '../draw-skin.ts';
import type { Frame } from '../frame.ts';
import type { Pass } from '../pass.ts';
import { showsWeights } from '../view-options.ts';

/** The diameter of the ring around the marked point, in pixels of the view. */
const markSize = 21;
/** The opacity of the ring where the skin hides its point. */
const hiddenOpacity = 0.35;

/**
 * Draws the selected character's skin in colors that stand for its weights, softly lit or as they
 * are, a ring around the marked point, and dims what the joint under the pointer does not move.
 */
export const weightsPass: Pass = {
  id: 'weights',
  isShown: ({ showSkin, weights }) => showSkin && weights !== null,
  create({ gl }, programs) {
    return {
      draw(frame) {
        const { options } = frame;
        const views = frame.characters.filter(({ state }) => showsWeights(state.id, options));
        for (const view of views) updateColors(view, frame);
        blendSkins(gl, frame, (opacity) => {
          for (const view of views) drawSkin(frame, view, opacity);
        });
        const { marked } = options.weights!;
        if (marked === null || !options.showOverlay) return;
        for (const view of views) drawMark(frame, view, marked);
      },
      dispose: () => undefined,
    };

    function drawSkin(frame: Frame, view: CharacterView, opacity: number): void {
      const { skinned, surfaces, display, state } = view;
      const defines: Defines = {
        INFLUENCE_PAIRS: skinned.influencePairs,
        ...(state.look.shading === 'faceted' && { FACETED: 1 }),
      };
      const program = programs.pass('weights', defines);
      program.use();
      program.set(frame.uniforms);
      const { sceneFromCharacter } = display;
      const { unlit } = frame.options.weights!;
      program.set({ sceneFromCharacter, opacity, unlit, litEntry: litEntryOf(frame, view) });
      skinned.bindInfluences(program);
      for (const { submesh, alpha } of surfaces) {
        // What the file makes invisible stays so; glass shows its weights like the rest.
        if (alpha > 0) drawOpaque(frame, view, program, submesh);
      }
    }

    function drawMark(frame: Frame, view: CharacterView, point: number): void {
      const program = programs.pass('point-mark');
      program.use();
      program.set(frame.uniforms);
      const { sceneFromCharacter } = view.display;
      program.set({ sceneFromCharacter, size: markSize * frame.scale });
      view.skinned.bind(program);
      gl.enable(gl.BLEND);
      gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
      for (const [depth, opacity] of [
        [gl.GREATER, hiddenOpacity],
        [gl.LEQUAL, 1],
      ] as const) {
        gl.depthFunc(depth);
        program.set({ opacity });
        gl.drawArrays(gl.POINTS, point, 1);
      }
      gl.depthMask(true);
      gl.depthFunc(gl.LESS);
      gl.disable(gl.BLEND);
    }
  },
};

/** The palette entry of the joint under the pointer, or -1: nothing is dimmed for one joint alone. */
function litEntryOf({ options }: Frame, { evaluation, state }: CharacterView): number {
  const { hoveredLimb, weights, showOverlay } = options;
  if (!showOverlay || weights?.view !== 'joints' || hoveredLimb?.actorId !== state.id) return -1;
  return evaluation.skin.paletteJoint.indexOf(hoveredLimb.joint);
}

/** What the colors of a character on the GPU were made from. */
const shown = new WeakMap<CharacterView, readonly unknown[]>();

/** Makes the colors of a character's vertices anew if what they show has changed. */
function updateColors(view: CharacterView, { options, detail }: Frame): void {
  const { evaluation, skinned } = view;
  const { skin, state, revisions } = evaluation;
  const { view: id, paint } = options.weights!;
  if (paint) {
    const painted = paint(evaluation);
    if (shown.get(view)?.[0] !== painted) skinned.writeColors(painted);
    shown.set(view, [painted]);
    return;
  }
  const joint =
    id === 'joint' ? (options.selectedJoint ?? options.hoveredLimb?.joint ?? null) : null;
  const key = [skin, id, joint, id === 'error' ? revisions.vertices : 0];
  const former = shown.get(view) ?? [];
  const isSame = (count: number): boolean =>
    key.slice(0, count).every((each, i) => each === former[i]);
  // Errors change with each pose; a draft keeps those of the last full picture.
  if (isSame(detail === 'draft' ? 3 : 4)) return;
  const truncation = id === 'error' ? truncationOf(evaluation) : null;
  const subject: WeightSubject = {
    skin,
    colors: jointColorsOf(state.character.skeleton),
    joint,
    errors: truncation?.errors ?? null,
    largestError: truncation?.largest ?? 0,
  };
  skinned.writeColors(vertexColors(id, subject, skinned.mesh.pointOf));
  shown.set(view, key);
}
