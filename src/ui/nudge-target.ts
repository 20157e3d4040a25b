import { mat4, vec3 } from 'gl-matrix';
import { setPose } from '../document/edits.ts';
import type { Gesture } from '../document/store.ts';
import { aimedPoint } from '../posing/ik/aimed-point.ts';
import { ChainDrag } from '../posing/ik/chain-drag.ts';
import { placeOf } from '../posing/ik/chain-problem.ts';
import type { IkSolver, Vector3 } from '../posing/ik/problem.ts';
import { axesOf } from '../view/camera.ts';
import { chainLengthOf } from './chain-length.ts';
import type { Looking, Telling } from './editor.ts';
import { heldGoals } from './held-goals.ts';
import { ikSolver, natureFinder } from './ik-solvers.ts';
import { fixedText } from './number-text.ts';

/** A direction of the keys, as the picture shows it. */
export type TargetAxis = 'right' | 'up' | 'look';

/** In scene units: without, and with Shift. */
const [step, fineStep] = [0.02, 0.002];

/** What the keys that are held move, as one step of undo. */
interface Held {
  readonly gesture: Gesture;
  readonly drag: ChainDrag;
  readonly joint: number;
  target: Vector3;
  seconds: number;
}

let held: Held | null = null;

/** Moves the target of the selected joint's chain by one step, and says where the joint is then. */
export async function nudgeTarget(
  editor: Looking & Telling,
  axis: TargetAxis,
  sign: 1 | -1,
  isFine: boolean,
): Promise<void> {
  const part = ikSolver(editor.session.ikMethod.value);
  // They are there since the mode began, and then nothing comes between a key and its step.
  if (!part.value || !natureFinder.value) await Promise.all([part.load(), natureFinder.load()]);
  const { evaluations, session, viewer, notice } = editor;
  const shown = evaluations.selected();
  const joint = session.selectedJoint.value;
  if (!shown || joint === null) return;
  if (!held?.gesture.isOpen || held.joint !== joint) held = hold(editor, joint, part.value!);
  const { state, display } = shown;
  const name = state.character.skeleton.names[joint]!;
  const characterFromScene = mat4.invert(new Float64Array(16), display.sceneFromCharacter)!;
  const by = vec3.scale(
    new Float64Array(3),
    axesOf(viewer.viewCamera.value)[axis],
    sign * (isFine ? fineStep : step),
  );
  const place = vec3.transformMat4(
    new Float64Array(3),
    [...held.target],
    display.sceneFromCharacter,
  );
  vec3.add(place, place, by);
  vec3.transformMat4(place, place, characterFromScene);
  held.target = [place[0], place[1], place[2]];
  held.seconds++;
  held.drag.aim(held.target, held.seconds);
  const { q, isApart } = held.drag.finish();
  held.gesture.preview(setPose(state.id, q, `Move ${name}`));
  // What can't be reached is no place to go on from.
  if (isApart) held.target = held.drag.place;
  notice.value = `${name} at ${placeText(editor, held.drag.place)}${isApart ? ', as far as it goes' : ''}`;
}

function hold(editor: Looking, joint: number, solver: IkSolver): Held {
  const shown = editor.evaluations.selected()!;
  const { character, natures } = shown.state;
  const q = shown.poseToEdit.q.slice();
  const { count } = chainLengthOf(editor, joint);
  const point = aimedPoint(character, q, joint, count);
  const drag = new ChainDrag({
    ...{ skeleton: character.skeleton, q, joint, point, count, solver, seconds: 0 },
    held: heldGoals(shown),
    natures: natureFinder.value!(character, natures),
  });
  const gesture = editor.store.begin(`Move ${character.skeleton.names[joint]!}`);
  window.addEventListener('keyup', () => gesture.commit(), { once: true });
  const target = placeOf(shown.characterFromJoint, joint, point);
  return { gesture, drag, joint, target, seconds: 0 };
}

function placeText({ evaluations }: Looking, place: Vector3): string {
  const { sceneFromCharacter } = evaluations.selected()!.display;
  const at = vec3.transformMat4(new Float64Array(3), [...place], sceneFromCharacter);
  return Array.from(at, fixedText).join(', ');
}
