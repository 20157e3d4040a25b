import { computed, effect } from '@preact/signals-core';
import { sameValue } from '../../core/same-value.ts';
import type { RotationPaths } from '../../document/rotation-paths.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { Kernels } from '../../evaluation/kernels.ts';
import type { ChartValues } from '../../posing/charts/chart.ts';
import { valuesAt } from '../../posing/charts/chart-curve.ts';
import { ownRotation } from '../../posing/charts/joint-charts.ts';
import { timeInClip } from '../../posing/playhead.ts';
import { failureText } from '../attempt.ts';
import type { Editor } from '../editor.ts';
import { conversionsOf } from './conversions.ts';
import { endPaths } from './end-paths.ts';
import { type Subject, subjectOf } from './subject.ts';

/** The parts of the editor that the lab uses. */
export type LabEditor = Pick<Editor, 'store' | 'session' | 'transport' | 'tab' | 'notice'>;

/**
 * The state of the rotation lab: the rotation of the selected joint over the chosen clip, in three
 * charts, and the paths of its end. It follows the selection and every change of the clip; while a
 * clip plays, nothing but the playhead is computed again.
 */
export class RotationLab {
  private readonly editor: LabEditor;
  private readonly kernels: Kernels;
  private readonly end: () => void;
  private last: { readonly of: readonly unknown[]; readonly found: Subject | string } | undefined;

  private readonly found = computed((): Subject | string => {
    const { store, session, transport } = this.editor;
    const actor = selectedActor(store, session);
    const index = transport.clipIndex;
    const joint = session.selectedJoint.value;
    // Most edits of an actor change neither its clip nor the values that the clip leaves alone.
    const of = [actor?.id, actor?.character, actor?.clips[index], actor?.q, index, joint];
    if (this.last?.of.every((each, i) => isSame(each, of[i]))) return this.last.found;
    const found = subjectOf(actor, index, joint);
    this.last = { of, found };
    return found;
  });

  /** What is shown, or null if there is nothing to show. */
  readonly subject = computed(() =>
    typeof this.found.value === 'string' ? null : this.found.value,
  );
  /** Why there is nothing to show, for the user. */
  readonly refusal = computed(() => (typeof this.found.value === 'string' ? this.found.value : ''));

  /** The same motion by every kind of curve. */
  readonly conversions = computed(() => {
    const subject = this.subject.value;
    return subject ? conversionsOf(subject) : [];
  });

  /** The time in the clip, in seconds. */
  readonly time = computed(() => {
    const { clipTime, playMode } = this.editor.session;
    const subject = this.subject.value;
    return subject ? timeInClip(subject.clip, clipTime.value, playMode.value) : 0;
  });

  /** The numbers of every chart at that time. */
  readonly values = computed((): readonly ChartValues[] => {
    const subject = this.subject.value;
    if (!subject) return [];
    const { motion, curves, actor, joint } = subject;
    const rotation = ownRotation(actor.character.skeleton, joint, motion.valuesAt(this.time.value));
    return curves.map((curve) => valuesAt(curve, this.time.value, rotation));
  });

  private readonly paths = computed((): RotationPaths | null => {
    const subject = this.subject.value;
    if (!subject) return null;
    const paths = endPaths(subject, this.conversions.value, this.kernels);
    return { actorId: subject.actor.id, paths };
  });

  constructor(editor: LabEditor) {
    this.editor = editor;
    this.kernels = new Kernels({
      onFailed: (error) => (editor.notice.value = failureText(error)),
    });
    this.end = effect(() => {
      const isShown = editor.tab.value === 'animate';
      editor.session.rotationPaths.value = isShown ? this.paths.value : null;
    });
  }

  dispose(): void {
    this.end();
    this.editor.session.rotationPaths.value = null;
  }
}

/** Values of q are compared by their bits, everything else by identity. */
function isSame(a: unknown, b: unknown): boolean {
  return a === b || (a instanceof Float64Array && sameValue(a, b));
}
