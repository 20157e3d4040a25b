import { computed, signal } from '@preact/signals-core';
import { printable } from '../../core/diagnostics.ts';
import type { Skeleton } from '../../core/skeleton.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { tellingJoint } from '../../posing/telling-poses.ts';
import type { Sweep } from '../../evaluation/comparison/sweep.ts';
import { sweepRows } from '../../evaluation/comparison/sweep-rows.ts';
import { type TurnRange, turnRanges } from '../../evaluation/comparison/turn-range.ts';
import { writeCsv } from '../../formats/csv/write-csv.ts';
import type { MethodId } from '../../skinning/method.ts';
import { methods } from '../../skinning/registry.ts';
import { attempt } from '../attempt.ts';
import { download } from '../download.ts';
import type { Editor } from '../editor.ts';
import { axisNames } from '../joint-values.ts';
import { Measurement } from './measurement.ts';

/** How many steps a sweep has. */
const steps = 36;

/** A sweep with the names that belong to it. */
export interface NamedSweep extends Sweep {
  readonly character: string;
  readonly joint: string;
  readonly axis: string;
}

/** The state of the sweep panel: what is to be swept by which methods, and the last sweep. */
export class SweepLab {
  readonly measurement: Measurement<NamedSweep>;
  /** The methods, in the registry's order. */
  readonly chosen = signal<readonly MethodId[]>(['linear-blend', 'dual-quaternion']);
  private readonly editor: Editor;
  private readonly wantedJoint = signal<number | null>(null);
  private readonly wantedAxis = signal<0 | 1 | 2 | null>(null);

  constructor(editor: Editor) {
    this.editor = editor;
    this.measurement = new Measurement(editor);
  }

  readonly actor = computed<Actor | undefined>(() =>
    selectedActor(this.editor.store, this.editor.session),
  );

  /** The joints that can turn. */
  readonly joints = computed<readonly number[]>(() => {
    const skeleton = this.actor.value?.character.skeleton;
    if (!skeleton) return [];
    return Array.from({ length: skeleton.jointCount }, (_, joint) => joint).filter(
      (joint) => turnRanges(skeleton, joint).length > 0,
    );
  });

  /** The joint that was chosen here, else the selected one, else a telling one. */
  readonly joint = computed<number | null>(() => {
    const character = this.actor.value?.character;
    const joints = this.joints.value;
    const wishes = [
      this.wantedJoint.value,
      this.editor.session.selectedJoint.value,
      character ? tellingJoint(character) : null,
    ];
    return wishes.find((joint) => joint !== null && joints.includes(joint)) ?? joints[0] ?? null;
  });

  readonly ranges = computed<readonly TurnRange[]>(() => {
    const [actor, joint] = [this.actor.value, this.joint.value];
    return actor && joint !== null ? turnRanges(actor.character.skeleton, joint) : [];
  });

  readonly range = computed<TurnRange | undefined>(() => {
    const ranges = this.ranges.value;
    return ranges.find(({ axis }) => axis === this.wantedAxis.value) ?? ranges[0];
  });

  chooseJoint(joint: number): void {
    this.wantedJoint.value = joint;
    this.sweep();
  }

  chooseAxis(axis: 0 | 1 | 2): void {
    this.wantedAxis.value = axis;
    this.sweep();
  }

  /** Adds a method, or takes it out. */
  toggleMethod(method: MethodId): void {
    const now = this.chosen.value;
    const wanted = now.includes(method) ? now.filter((id) => id !== method) : [...now, method];
    this.chosen.value = methods.map(({ id }) => id).filter((id) => wanted.includes(id));
    this.sweep();
  }

  /** Sweeps from the pose that is shown now. */
  sweep(): void {
    const [actor, range, ids] = [this.actor.peek(), this.range.peek(), this.chosen.peek()];
    if (!actor?.character.mesh.pointCount || !range || ids.length === 0) {
      this.measurement.cancel();
      return;
    }
    const { skeleton } = actor.character;
    const names = {
      character: actor.name,
      joint: nameOf(skeleton, range.joint),
      axis: axisNames[range.axis],
    };
    const plan = { range, steps };
    const complete = (sweep: Sweep): NamedSweep => ({ ...names, ...sweep });
    const work = this.measurement.start('sweep', actor, ids, () => plan, complete);
    attempt(this.editor, work);
  }

  saveCsv(): void {
    const sweep = this.measurement.result.peek();
    if (!sweep) return;
    download(`${fileName(sweep)}.csv`, writeCsv(sweepRows(sweep)), 'text/csv');
    this.editor.notice.value = 'Table of the sweep saved';
  }

  /** @param text of an SVG */
  savePicture(text: string): void {
    const sweep = this.measurement.result.peek();
    if (!sweep) return;
    download(`${fileName(sweep)}.svg`, text, 'image/svg+xml');
    this.editor.notice.value = 'Picture of the sweep saved';
  }
}

/** The name of a joint, for text. */
export function nameOf({ names }: Skeleton, joint: number): string {
  return printable(names[joint]!, 60);
}

function fileName({ character, joint, axis }: NamedSweep): string {
  return `${character}-sweep-${joint}-${axis.toLowerCase()}`;
}
