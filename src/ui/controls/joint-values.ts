import type { GUI } from 'lil-gui';
import { diagonal } from '../../core/bounds.ts';
import type { Edit } from '../../document/edit.ts';
import { setPose } from '../../document/edits.ts';
import type { Actor } from '../../document/scene.ts';
import { selectedJoints } from '../../document/selected-joints.ts';
import type { Looking, Posing } from '../editor.ts';
import { valueIn, withValue } from '../joint-edits.ts';
import { keyedState } from '../keyed-state.ts';
import { axisNames, type JointValue, jointValues, valueName } from '../joint-values.ts';
import { addValueRow, type ValueRow } from './value-row.ts';

/** A row with one value of a joint. */
export interface JointValueRow extends ValueRow {
  /** "Left knee X", "Hips Move Y". */
  readonly fullName: string;
}

export function jointName({ character: { skeleton } }: Actor, joint: number): string {
  return skeleton.names[joint]!;
}

export function fullNameOf(state: Actor, joint: number, value: JointValue): string {
  return `${jointName(state, joint)} ${valueName(value)}`;
}

/** Adds a row for each value of a joint: its slides, hinges, or the three angles of its ball. */
export function addJointValues(
  folder: GUI,
  editor: Looking & Posing,
  state: Actor,
  joint: number,
): readonly JointValueRow[] {
  const { store, session, evaluations } = editor;
  const { id, character } = state;
  const { skeleton } = character;
  /** (qCount) the pose that edits start from. */
  const shown = (): Float64Array => evaluations.selected()?.poseToEdit.q ?? state.q;
  const read = (value: JointValue, q: Float64Array): number => valueIn(editor, skeleton, q, value);
  const write = (value: JointValue, from: Float64Array, number: number, label: string): Edit => {
    // With one of several selected joints, the others change too.
    const selected = selectedJoints(session);
    const others = selected.includes(joint) ? selected.filter((each) => each !== joint) : [];
    return setPose(id, withValue(editor, skeleton, from, [joint, ...others], value, number), label);
  };
  /** The pose at which the present gesture began: pins may move other joints meanwhile. */
  let start = state.q;

  return jointValues(skeleton, joint).map((value) => {
    const { isAngle, axis, index, ofBall } = value;
    const reach = isAngle ? Math.PI : diagonal(character.bounds);
    const fullName = fullNameOf(state, joint, value);
    const label = `${isAngle ? 'Turn' : 'Move'} ${jointName(state, joint)} ${axisNames[axis]}`;
    const [least, most] = ofBall
      ? [-Infinity, Infinity]
      : [skeleton.qMin[index]!, skeleton.qMax[index]!];
    const row = addValueRow(folder, {
      name: valueName(value),
      fullName,
      axis,
      locked: least === most,
      minimum: Math.max(least, -reach),
      maximum: Math.min(most, reach),
      isAngle,
      legal: [least, most],
      read: () => read(value, shown()),
      keyed: () => keyedState(editor, evaluations.selected()?.state, 'values', index),
      begin: () => {
        const active = { name: fullName, index, isAngle, isChosen: true };
        start = shown().slice();
        session.activeDof.value = ofBall ? { ...active, ballAxis: axis } : active;
        return store.begin(label);
      },
      preview: (gesture, number) => gesture.preview(write(value, start, number, label)),
      reset: () => {
        const rest = read(value, skeleton.qRest);
        store.dispatch(write(value, shown(), rest, `Reset ${fullName}`));
      },
    });
    return { ...row, fullName };
  });
}
