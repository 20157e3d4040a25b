import { batch, type Signal, signal } from '@preact/signals-core';
import { printable } from '../core/diagnostics.ts';
import type { Character } from '../core/character.ts';
import type { Pose } from '../core/pose.ts';
import { sameValue } from '../core/same-value.ts';
import { type SavedPose, setPoseAndShape } from '../document/saved-poses.ts';
import { type Actor, actorById } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import type { Gesture } from '../document/store.ts';
import { blendPoses } from '../posing/blend-poses.ts';
import { fitPose, type FittedPose } from '../posing/fit-pose.ts';
import type { NamedPose } from '../posing/named-pose.ts';
import { mirrorJoints, symmetryOf } from '../posing/symmetry/symmetry.ts';
import { attempt } from './attempt.ts';
import type { BundledPose, Editor } from './editor.ts';
import { keyOf } from './saved-poses.ts';

/** A pose that the library offers for a character. */
export interface LibraryPose {
  readonly key: string;
  readonly name: string;
  readonly pose: NamedPose;
  /** What the scene has; absent for a pose that comes with the character. */
  readonly saved?: SavedPose;
  /** Its place in the picture of the poses that come with the character: 0 at its top, 1 at its end. */
  readonly place?: number;
}

/** How a pose came to be by blending, by the values that it has. */
interface Blend {
  readonly key: string;
  readonly before: Required<Pose>;
  readonly fraction: number;
}

/**
 * The library of poses: those of the scene, and those that come with bundled characters. Applying
 * one is a step of undo, and so is each drag that blends it in; both start from what was shown
 * before it was applied.
 */
export class PoseLibrary {
  private readonly editor: Editor;
  private readonly bundled = new WeakMap<Character, Signal<readonly BundledPose[]>>();
  /** By the values of the actor, so that undo and redo find them too. */
  private readonly blends = new WeakMap<Float64Array, Blend>();
  private gesture: Gesture | null = null;
  private blended: { readonly pose: LibraryPose; readonly before: Required<Pose> } | null = null;

  constructor(editor: Editor) {
    this.editor = editor;
  }

  /** The poses for a character; those that come with it may still be on their way. */
  posesFor(actor: Actor | undefined): readonly LibraryPose[] {
    const saved = this.editor.store.scene.value.poses.map((pose) => {
      return { key: keyOf(pose), name: pose.name, pose, saved: pose };
    });
    const own = actor ? this.bundledFor(actor).value : [];
    const ofCharacter = own.map(({ name, pose }, index) => {
      return { key: `bundled ${name}`, name, pose, place: index / Math.max(1, own.length - 1) };
    });
    return [...ofCharacter, ...saved];
  }

  /** The pose that was applied last, if the library offers it for a character. */
  chosenFor(actor: Actor | undefined): LibraryPose | undefined {
    const key = this.editor.session.chosenPose.value;
    return key === null ? undefined : this.posesFor(actor).find((pose) => pose.key === key);
  }

  /**
   * How much of a pose an actor has by blending, from 0 to 1; null if the actor is in the pose
   * otherwise, so that there is nothing to blend.
   */
  fractionOf(actor: Actor, pose: LibraryPose): number | null {
    const blend = this.blends.get(actor.q);
    if (blend?.key === pose.key) return blend.fraction;
    const { character, q, morphWeights } = actor;
    const fitted = fitPose(character, { q, morphWeights }, pose.pose).pose;
    return sameValue(fitted, { q, morphWeights }) ? null : 0;
  }

  /** Whether a character takes anything of a pose. */
  fits({ character, q, morphWeights }: Actor, { pose }: LibraryPose): boolean {
    const { joints, missing } = fitPose(character, { q, morphWeights }, pose);
    return joints.length > 0 || missing.length < pose.joints.length + pose.morphs.length;
  }

  /** Puts the selected character into the mirror image of a pose. */
  applyMirrored(pose: LibraryPose): void {
    const actor = this.selected;
    if (!actor) return;
    this.endBlend();
    const { character, id, name } = actor;
    const before = this.beforeOf(actor, pose);
    const fitted = fitPose(character, before, pose.pose);
    const symmetry = symmetryOf(character.skeleton);
    const { q, alone } = mirrorJoints(symmetry, fitted.pose.q, before.q, fitted.joints);
    const { store, session, notice } = this.editor;
    const mirrored = { q, morphWeights: fitted.pose.morphWeights };
    batch(() => {
      store.dispatch(setPoseAndShape(id, mirrored, `Pose ${name}: ${pose.name}, mirrored`));
      session.chosenPose.value = pose.key;
    });
    const others = alone.map((joint) => character.skeleton.names[joint]!);
    const told = others.length > 0 ? `; ${namesOf(others)} without a partner` : '';
    notice.value = `${toldFit(pose.name, fitted)}, mirrored${told}`;
  }

  /** Puts the selected character into a pose. */
  apply(pose: LibraryPose): void {
    const actor = this.selected;
    if (!actor) return;
    this.endBlend();
    const before = this.beforeOf(actor, pose);
    const fitted = fitPose(actor.character, before, pose.pose);
    const { store, session, notice } = this.editor;
    batch(() => {
      store.dispatch(setPoseAndShape(actor.id, fitted.pose, `Pose ${actor.name}: ${pose.name}`));
      session.chosenPose.value = pose.key;
      this.remember(actor, { key: pose.key, before, fraction: 1 });
    });
    notice.value = toldFit(pose.name, fitted);
  }

  /** Shows a pose blended in by a fraction; the first call of a drag begins a gesture. */
  blend(pose: LibraryPose, fraction: number): void {
    const actor = this.selected;
    if (!actor) return;
    if (this.blended?.pose.key !== pose.key) {
      this.endBlend();
      this.blended = { pose, before: this.beforeOf(actor, pose) };
      this.gesture = this.editor.store.begin(`Blend in ${pose.name}`);
    }
    if (!this.gesture?.isOpen) return; // Esc took the drag back
    const { before } = this.blended;
    const { character, id } = actor;
    const target = fitPose(character, before, pose.pose).pose;
    const shown = blendPoses(character.skeleton, before, target, fraction);
    this.gesture.preview(setPoseAndShape(id, shown, ''));
    this.remember(actor, { key: pose.key, before, fraction });
    this.editor.notice.value = `${pose.name} ${Math.round(fraction * 100)} %`;
  }

  /** Ends a drag of the slider. */
  endBlend(): void {
    this.gesture?.commit();
    this.gesture = null;
    this.blended = null;
  }

  private get selected(): Actor | undefined {
    return selectedActor(this.editor.store, this.editor.session);
  }

  /** What a character showed before a pose was blended in. */
  private beforeOf(actor: Actor, { key }: LibraryPose): Required<Pose> {
    const blend = this.blends.get(actor.q);
    if (blend?.key === key) return blend.before;
    return this.editor.evaluations.of(actor).snapshot();
  }

  /** Notes how the actor's present values came to be. */
  private remember({ id }: Actor, blend: Blend): void {
    const now = actorById(this.editor.store.scene.peek(), id);
    if (now) this.blends.set(now.q, blend);
  }

  private bundledFor({ character, source }: Actor): Signal<readonly BundledPose[]> {
    let poses = this.bundled.get(character);
    if (!poses) {
      const list = signal<readonly BundledPose[]>([]);
      this.bundled.set(character, (poses = list));
      if (source.kind === 'bundled') {
        const { notice } = this.editor;
        const fetched = this.editor.bundledPoses(source.id, character);
        attempt(
          { notice },
          fetched.then((found) => void (list.value = found)),
        );
      }
    }
    return poses;
  }
}

/** The library of an editor; there is one. */
export function poseLibraryOf(editor: Editor): PoseLibrary {
  let library = libraries.get(editor);
  if (!library) libraries.set(editor, (library = new PoseLibrary(editor)));
  return library;
}

const libraries = new WeakMap<Editor, PoseLibrary>();

/** Says that a pose was applied, and what of it did not fit. */
function toldFit(name: string, { joints, missing, partly }: FittedPose): string {
  if (missing.length + partly.length === 0) return `${name} applied`;
  const faults = [
    ...(missing.length > 0 ? [`${namesOf(missing)} not found`] : []),
    ...(partly.length > 0 ? [`${namesOf(partly)} only in part`] : []),
  ];
  return `${name} applied to ${joints.length} joints; ${faults.join(', ')}`;
}

function namesOf([first, ...others]: readonly string[]): string {
  const named = printable(first!, 40);
  return others.length > 0 ? `${named} and ${others.length} more` : named;
}
