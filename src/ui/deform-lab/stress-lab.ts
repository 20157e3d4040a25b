import { computed, signal } from '@preact/signals-core';
import { comparisonOf, mostMethods } from '../../document/comparison.ts';
import { setPose } from '../../document/edits.ts';
import { type Actor, actorById } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import type { Session } from '../../document/session.ts';
import {
  type StressRow,
  type StressSuite,
  worstFirst,
} from '../../evaluation/comparison/stress.ts';
import { usualRanges } from '../../evaluation/comparison/stress-poses.ts';
import { stressLabel, stressRows } from '../../evaluation/comparison/stress-rows.ts';
import { writeCsv } from '../../formats/csv/write-csv.ts';
import type { MethodId } from '../../skinning/method.ts';
import { methods } from '../../skinning/registry.ts';
import { download } from '../download.ts';
import type { Editor } from '../editor.ts';
import { Measurement, type Progress } from './measurement.ts';
import { showsStressSheet } from './measures-open.ts';
import { showWorst } from './open-comparison.ts';
import { StressPictures } from './stress-pictures.ts';

/** A suite with the character to which it belongs. */
export interface MeasuredSuite extends StressSuite {
  /** As it was measured; it is in no scene. */
  readonly actor: Actor;
  /** The id that it has in the scene, and its name there. */
  readonly id: Actor['id'];
  readonly name: string;
}

const degree = Math.PI / 180;

/** So many methods at least are compared. */
export const fewestMethods = 2;

/** The state of the stress suite: what is to be measured and drawn, and the last suite. */
export class StressLab {
  readonly measurement: Measurement<MeasuredSuite>;
  readonly pictures: StressPictures;
  /** From `fewestMethods` to `mostMethods`, in the registry's order. */
  readonly chosen = signal<readonly MethodId[]>(['linear-blend', 'dual-quaternion']);
  private readonly wantedBase = signal<MethodId | null>(null);
  /** Whether joints turn from the pose that is shown, and not from that of the file. */
  readonly fromShown = signal(false);
  /** How far joints without limits turn at most across and about their bones, in degrees. */
  readonly bend = signal(Math.round(usualRanges.bend / degree));
  readonly twist = signal(Math.round(usualRanges.twist / degree));
  /** How many poses get pictures. */
  readonly pictureCount = signal(12);
  readonly isWorstFirst = signal(true);
  /** The row whose pose was put on the character last. */
  private readonly lastShown = signal<StressRow | null>(null);
  private readonly editor: Editor;

  constructor(editor: Editor) {
    this.editor = editor;
    this.measurement = new Measurement(editor);
    this.pictures = new StressPictures(editor);
  }

  readonly actor = computed<Actor | undefined>(() =>
    selectedActor(this.editor.store, this.editor.session),
  );

  /** The chosen one, else the first method. */
  readonly base = computed<MethodId>(() => {
    const chosen = this.chosen.value;
    return chosen.find((id) => id === this.wantedBase.value) ?? chosen[0]!;
  });

  /** How far the work is, or null while there is none. */
  readonly progress = computed<Progress | null>(() => {
    const part = this.pictures.part.value;
    return (
      this.measurement.progress.value ?? (part === null ? null : { text: 'Drawing pictures', part })
    );
  });

  /** The poses in the order that is chosen. */
  readonly rows = computed<readonly StressRow[]>(() => {
    const rows = this.measurement.result.value?.rows ?? [];
    return this.isWorstFirst.value ? worstFirst(rows) : rows;
  });

  /** The row whose pose the character has, if it was shown. */
  readonly shownRow = computed<StressRow | null>(() => {
    const [row, id] = [this.lastShown.value, this.measurement.result.value?.id ?? null];
    const q = actorById(this.editor.store.scene.value, id)?.q;
    return row && q && row.pose.q.every((value, i) => value === q[i]) ? row : null;
  });

  chooseBase(method: MethodId): void {
    this.wantedBase.value = method;
  }

  /** Adds a method or takes it out, where that leaves a number of methods that can be compared. */
  toggleMethod(method: MethodId): void {
    const now = this.chosen.value;
    const wanted = now.includes(method) ? now.filter((id) => id !== method) : [...now, method];
    if (wanted.length < fewestMethods || wanted.length > mostMethods) return;
    this.chosen.value = methods.map(({ id }) => id).filter((id) => wanted.includes(id));
  }

  cancel(): void {
    this.measurement.cancel();
    this.pictures.cancel();
  }

  /** Measures the selected character, and then draws the worst poses. */
  async run(): Promise<void> {
    const [actor, base] = [this.actor.peek(), this.base.peek()];
    if (!actor || actor.character.mesh.pointCount === 0) {
      this.editor.notice.value = 'Select a character with a mesh';
      return;
    }
    this.cancel();
    showsStressSheet.value = true;
    // The base stands first, as in a comparison.
    const ids = [base, ...this.chosen.peek().filter((id) => id !== base)];
    const { character, id, name } = actor;
    const fromShown = this.fromShown.peek();
    const ranges = { bend: this.bend.peek() * degree, twist: this.twist.peek() * degree };
    const before = this.measurement.result.peek();
    const planOf = ({ q }: Actor) => ({
      q: fromShown ? q : character.skeleton.qRest,
      ranges,
      base: 0,
    });
    const complete = (suite: StressSuite, plain: Actor) => ({ ...suite, actor: plain, id, name });
    await this.measurement.start('stress', actor, ids, planOf, complete);
    const suite = this.measurement.result.peek();
    if (suite && suite !== before) {
      await this.pictures.draw(suite, suite.actor, this.pictureCount.peek());
    }
  }

  /** Gives the character a pose of the suite, as one step of undo, and compares the methods there. */
  async show(row: StressRow): Promise<void> {
    const { pose } = row;
    const { store, session, evaluations, notice } = this.editor;
    const suite = this.measurement.result.peek();
    const actor = actorById(store.scene.peek(), suite?.id ?? null);
    if (!suite || actor?.character !== suite.actor.character) {
      notice.value = 'The character of this suite is no longer there; run it anew';
      return;
    }
    if (selectedActor(store, session)?.id !== actor.id) this.editor.select(actor.id);
    store.dispatch(setPose(actor.id, pose.q, stressLabel(actor.character.skeleton, pose)));
    this.lastShown.value = row;
    await evaluations.prepare(suite.methods);
    const now = session.comparison.peek();
    if (now?.methods.join() !== suite.methods.join()) {
      session.comparison.value = comparisonOf(suite.methods);
    }
    showWorst(this.editor);
  }

  saveCsv(): void {
    const suite = this.measurement.result.peek();
    if (!suite) return;
    const rows = stressRows(suite.actor.character.skeleton, suite);
    download(`${suite.name}-stress.csv`, writeCsv(rows), 'text/csv');
    this.editor.notice.value = 'Table of the stress suite saved';
  }
}

const known = new WeakMap<Session, StressLab>();

/** The suite of a page; it stays while its panels are closed. */
export function stressLabOf(editor: Editor): StressLab {
  let lab = known.get(editor.session);
  if (!lab) known.set(editor.session, (lab = new StressLab(editor)));
  return lab;
}
