import { batch, computed, effect, signal, untracked } from '@preact/signals-core';
import { sameValue } from '../core/same-value.ts';
import { setPose } from '../document/edits.ts';
import type { IkSketch } from '../document/ik-sketch.ts';
import type { Actor } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { pathTo } from '../posing/ik/chain.ts';
import { type LabRun, type LabStep, runLab } from '../posing/ik/lab.ts';
import {
  chainStart,
  type LabChain,
  labChain,
  pathPlaces,
  problemOf,
} from '../posing/ik/lab-chain.ts';
import { manipulability } from '../posing/ik/lab-ellipsoid.ts';
import { labTask, type LabTask, type TargetKind } from '../posing/ik/lab-targets.ts';
import type { IkMethod, IkMethodId, IkSolver, Vector3 } from '../posing/ik/problem.ts';
import { naturesInUse } from '../posing/natural/natures-in-use.ts';
import type { Editor } from './editor.ts';

/** The parts of the editor that the lab uses. */
export type LabEditor = Pick<Editor, 'store' | 'session' | 'evaluations' | 'notice' | 'tab'>;

/** A method whose code is loaded. */
export type LabMethod = Pick<IkMethod, 'id' | 'label' | 'summary'> & { readonly solver: IkSolver };

/** What one of the methods did with the task. */
export interface MethodRun extends LabRun {
  readonly method: LabMethod;
}

/** What the lab is about: a chain of a character, from a pose to a target. */
export interface Subject extends LabTask {
  readonly actor: Actor;
  readonly chain: LabChain;
  /** The kind of the target, or null for a place that was typed. */
  readonly kind: TargetKind | null;
  /** (qCount) the pose that was shown when the target was set. */
  readonly shownThen: Float64Array;
}

/** The most earlier steps that the view shows. */
const mostEarlier = 12;
/** The longest half axis of the ellipsoid in the view, as a part of the chain's length. */
const ellipsoidPart = 0.18;

/**
 * The state of the IK lab: a target for the selected joint, and what each method does to reach it,
 * step by step. Until `apply`, the scene stays as it is.
 */
export class IkLab {
  readonly methods: readonly LabMethod[];
  readonly methodId = signal<IkMethodId>('dls');
  /** Whether the steps are being shown one after the other. */
  readonly playing = signal(false);
  private readonly editor: LabEditor;
  private readonly wantsNatural = signal<boolean | null>(null);
  private readonly wantedStep = signal(0);
  private readonly found = signal<Subject | string>('');
  private readonly ends: readonly (() => void)[];

  /** The task, or null if there is none. */
  readonly subject = computed(() =>
    typeof this.found.value === 'string' ? null : this.found.value,
  );
  /** Why there is no task, for the user. */
  readonly refusal = computed(() => (typeof this.found.value === 'string' ? this.found.value : ''));

  /** How the joints of the chain move by nature, as far as it is known. */
  readonly natures = computed(() => {
    const subject = this.subject.value;
    if (!subject) return [];
    const { actor, chain } = subject;
    const all = naturesInUse(actor.character, { ...actor.natures, isOn: true });
    return all.filter(({ joint }) => chain.moving.includes(joint));
  });

  /** Whether methods that know of natures keep to them: as the character does, or as chosen here. */
  readonly isNatural = computed(
    () => this.wantsNatural.value ?? this.subject.value?.actor.natures.isOn ?? false,
  );

  /** What each method does, in their order; empty without a task. */
  readonly runs = computed((): readonly MethodRun[] => {
    const subject = this.subject.value;
    if (!subject) return [];
    const natures = this.isNatural.value ? this.natures.value : [];
    const problem = problemOf(subject.chain, subject.q, subject.target, natures);
    return this.methods.map((method) => ({ method, ...runLab(method.solver, problem) }));
  });

  readonly run = computed(() =>
    this.runs.value.find(({ method }) => method.id === this.methodId.value),
  );

  readonly lastStep = computed(() => Math.max(0, (this.run.value?.steps.length ?? 0) - 1));

  /** The number of the shown step; 0 is the start. */
  readonly at = computed(() => Math.min(this.wantedStep.value, this.lastStep.value));

  readonly step = computed(() => this.run.value?.steps[this.at.value]);

  /** How turns can move the effector at the shown step: the axes of an ellipsoid. */
  readonly ellipsoid = computed(() => {
    const [subject, step] = [this.subject.value, this.step.value];
    return subject && step ? manipulability(subject.chain, step.q) : [];
  });

  /** Whether the shown pose is another one than that from which the methods start. */
  readonly isPoseNew = computed(() => {
    const [subject, shown] = [this.subject.value, this.editor.evaluations.selected()];
    return (
      subject !== null && shown !== undefined && !sameValue(subject.shownThen, shown.poseToEdit.q)
    );
  });

  constructor(editor: LabEditor, methods: readonly LabMethod[]) {
    this.editor = editor;
    this.methods = methods;
    this.ends = [
      effect(() => this.followSelection()),
      effect(() => {
        editor.session.ikSketch.value = editor.tab.value === 'pose' ? this.sketch() : null;
      }),
    ];
  }

  /** Shows a step, or the nearest one that there is. */
  goTo(step: number): void {
    this.wantedStep.value = Math.min(Math.max(step, 0), this.lastStep.peek());
    if (this.at.peek() === this.lastStep.peek()) this.playing.value = false;
  }

  togglePlay(): void {
    if (!this.playing.peek() && this.at.peek() === this.lastStep.peek()) this.goTo(0);
    this.playing.value = !this.playing.peek() && this.lastStep.peek() > 0;
  }

  chooseMethod(id: IkMethodId): void {
    this.playing.value = false;
    this.methodId.value = id;
  }

  setNatural(isNatural: boolean): void {
    batch(() => {
      this.playing.value = false;
      this.wantedStep.value = 0;
      this.wantsNatural.value = isNatural;
    });
  }

  /** Starts from the pose that is shown now, to a target of a kind. */
  aimAt(kind: TargetKind, start?: number): void {
    const subject = this.subject.peek();
    if (!subject) return;
    const effector = subject.chain.path.at(-1)!;
    this.begin(
      subjectFor(this.editor, this.solver, effector, kind, start ?? subject.chain.path[0]),
    );
  }

  /** Sets the target to a place, in the character's space and model units. */
  moveTarget(target: Vector3): void {
    const subject = this.subject.peek();
    if (subject) this.begin({ ...subject, target, kind: null });
  }

  /** Starts from the pose that is shown now, to the same target. */
  startFromShown(): void {
    const [subject, shown] = [this.subject.peek(), this.editor.evaluations.selected()];
    if (!subject || !shown) return;
    const q = shown.poseToEdit.q.slice();
    this.begin({ ...subject, q, shownThen: q });
  }

  /** Gives the character the pose of the shown step, as one step of undo. */
  apply(): void {
    const [subject, run, step] = [this.subject.peek(), this.run.peek(), this.step.peek()];
    if (!subject || !run || !step) return;
    const { store, notice } = this.editor;
    store.dispatch(setPose(subject.actor.id, step.q, 'Pose of the IK lab'));
    notice.value = `${subject.actor.name} has the pose of step ${this.at.peek()} of ${run.method.label}`;
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.editor.session.ikSketch.value = null;
  }

  private get solver(): IkSolver {
    return this.methods[0]!.solver;
  }

  private begin(found: Subject | string): void {
    batch(() => {
      this.playing.value = false;
      this.wantedStep.value = 0;
      this.found.value = found;
    });
  }

  /** Another joint or another skeleton has a task of its own. */
  private followSelection(): void {
    const { store, session } = this.editor;
    const actor = selectedActor(store, session);
    const joint = session.selectedJoint.value;
    const now = this.found.peek();
    const isSame =
      typeof now !== 'string' &&
      now.actor.id === actor?.id &&
      now.chain.skeleton === actor.character.skeleton &&
      now.chain.path.at(-1) === joint;
    if (isSame) return;
    const editor = this.editor;
    untracked(() => this.begin(subjectFor(editor, this.solver, joint, 'reachable')));
  }

  private sketch(): IkSketch | null {
    const [subject, run] = [this.subject.value, this.run.value];
    if (!subject || !run) return null;
    const { chain, actor, target } = subject;
    const at = this.at.value;
    const placesAt = ({ q }: LabStep): readonly Vector3[] => pathPlaces(chain, q);
    const ellipsoid = this.ellipsoid.value;
    const scale = (ellipsoidPart * chain.length) / (ellipsoid[0]?.size || 1);
    return {
      actorId: actor.id,
      chain: placesAt(run.steps[at]!),
      earlier: run.steps.slice(Math.max(0, at - mostEarlier), at).map(placesAt),
      target,
      halfAxes: ellipsoid.map(({ direction: [x, y, z], size }) => {
        const length = size * scale;
        return [x * length, y * length, z * length];
      }),
    };
  }
}

/** Returns the task for a joint, or why there is none. */
function subjectFor(
  { evaluations }: LabEditor,
  solver: IkSolver,
  joint: number | null,
  kind: TargetKind,
  start?: number,
): Subject | string {
  const shown = evaluations.selected();
  if (!shown) return 'There is no character.';
  const { state: actor, poseToEdit } = shown;
  const { skeleton } = actor.character;
  if (joint === null) return 'Select a joint, such as a hand or a foot; here it gets a target.';
  const name = skeleton.names[joint]!;
  const from = start ?? chainStart(skeleton, joint);
  if (from === null) {
    return `${name} is a root: no joint above it can bring it to a target. Select one further out.`;
  }
  const chain = labChain(skeleton, from, joint);
  if (chain.moving.length === 0) {
    return `No joint between ${skeleton.names[from]!} and ${name} can turn, so nothing brings it to a target. Select one further out.`;
  }
  const shownThen = poseToEdit.q.slice();
  return { actor, chain, kind, shownThen, ...labTask(kind, chain, shownThen, solver) };
}

/** The joints from which a chain to a joint may start, the nearest first. */
export function possibleStarts({ skeleton, path }: LabChain): readonly number[] {
  return pathTo(skeleton, path.at(-1)!).slice(0, -1).reverse();
}
