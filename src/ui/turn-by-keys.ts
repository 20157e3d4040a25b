import { setPose } from '../document/edits.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import type { ActiveDof } from '../document/session.ts';
import type { Looking, Posing } from './editor.ts';
import { heldGesture } from './held-gesture.ts';
import { valueIn, withinLimits, withValue } from './joint-edits.ts';
import { axisNames, type JointValue, jointValues, valueName } from './joint-values.ts';
import { fine } from './tool.ts';

/** How far a key turns, in radians; a slide moves by this part of the character's size. */
const [turnStep, moveStep] = [(5 * Math.PI) / 180, 0.01];

/**
 * Turns the active angle of the selected joint by a step, and that of all joints that are selected
 * with it. A key that is held makes one step of undo.
 */
export function turnByKey(editor: Looking & Posing, sign: 1 | -1, isFine: boolean): void {
  const { store, session, evaluations } = editor;
  const shown = evaluations.selected();
  const values = valuesOf(editor);
  const value = values[activeIndex(values, session.activeDof.value)];
  if (!shown || !value) return;
  const { id, character } = shown.state;
  const { skeleton } = character;
  const joints = selectedJoints(session);
  const label = `${value.isAngle ? 'Turn' : 'Move'} ${skeleton.names[joints[0]!]!} ${axisNames[value.axis]}`;
  activate(editor, value);
  const unit = value.isAngle ? turnStep : moveStep / shown.display.scale;
  const { q } = shown.poseToEdit;
  const wanted = valueIn(editor, skeleton, q, value) + sign * unit * (isFine ? fine : 1);
  const number = withinLimits(skeleton, value, wanted);
  const next = withValue(editor, skeleton, q, joints, value, number);
  heldGesture(store, label).preview(setPose(id, next, label));
}

/** Makes the angle before or after the active one of the selected joint the active one. */
export function stepAxis(editor: Looking, step: 1 | -1): void {
  const values = valuesOf(editor);
  if (values.length === 0) return;
  const { activeDof } = editor.session;
  const at = activeIndex(values, activeDof.value);
  // The first press shows which one is active.
  const isShown = values.some((value) => isActive(value, activeDof.value));
  activate(editor, values.at((at + (isShown ? step : 0)) % values.length)!);
}

/** The index of the active value of the selected joint; if none is active, of its first angle. */
function activeIndex(values: readonly JointValue[], active: ActiveDof | null): number {
  const at = values.findIndex((value) => isActive(value, active));
  return at >= 0
    ? at
    : Math.max(
        0,
        values.findIndex(({ isAngle }) => isAngle),
      );
}

function isActive({ index, axis, ofBall }: JointValue, active: ActiveDof | null): boolean {
  return active?.index === index && (!ofBall || active.ballAxis === axis);
}

/** The values of the selected joint that are not locked by their limits. */
function valuesOf({ evaluations, session }: Looking): readonly JointValue[] {
  const skeleton = evaluations.selected()?.state.character.skeleton;
  const joint = session.selectedJoint.value;
  if (!skeleton || joint === null) return [];
  const { qMin, qMax } = skeleton;
  return jointValues(skeleton, joint).filter(
    ({ index, ofBall }) => ofBall || qMin[index]! < qMax[index]!,
  );
}

function activate({ session, evaluations }: Looking, value: JointValue): void {
  const { names } = evaluations.selected()!.state.character.skeleton;
  const { index, isAngle, axis, ofBall } = value;
  session.activeDof.value = {
    name: `${names[session.selectedJoint.value!]!} ${valueName(value)}`,
    isChosen: false,
    ...{ index, isAngle },
    ...(ofBall ? { ballAxis: axis } : {}),
  };
}
