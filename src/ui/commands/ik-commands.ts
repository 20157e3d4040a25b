import { resetNature, setNatural } from '../../document/nature-edits.ts';
import { selectedActor } from '../../document/selected-actor.ts';
import { chainLengthOf, changeChainLength } from '../chain-length.ts';
import type { Editor } from '../editor.ts';
import { type Command, toggle } from './command.ts';

const hasJoint = ({ session }: Editor): boolean => session.selectedJoint.value !== null;

/** Commands of inverse kinematics: whether drags use it, and how far its chains go. */
export const ikCommands = [
  {
    id: 'ik-mode',
    label: 'Inverse kinematics: a drag on a limb moves its whole chain',
    short: 'Inverse kinematics',
    keys: [{ key: 'i' }],
    isOn: ({ session }) => session.ikMode.value,
    run: toggleMode,
  },
  {
    id: 'longer-chain',
    label: 'One joint more in the chain that is dragged',
    short: 'Longer chain',
    keys: [{ key: ']' }],
    context: 'chain',
    isEnabled: hasJoint,
    run: (editor) => stepLength(editor, 1),
  },
  {
    id: 'shorter-chain',
    label: 'One joint less in the chain that is dragged',
    short: 'Shorter chain',
    keys: [{ key: '[' }],
    context: 'chain',
    isEnabled: hasJoint,
    run: (editor) => stepLength(editor, -1),
  },
  {
    id: 'natural-joints',
    label: 'Natural joints: inverse kinematics bends elbows, knees and others as they do by nature',
    short: 'Natural joints',
    isEnabled: (editor) => selectedActor(editor.store, editor.session) !== undefined,
    isOn: ({ store, session }) => selectedActor(store, session)?.natures.isOn ?? true,
    run: toggleNatural,
  },
  {
    id: 'reset-nature',
    label: 'Give the joint the soft ranges again that were found for it',
    short: 'Reset ranges',
    isEnabled: (editor) => ownNature(editor) !== undefined,
    run: (editor) => {
      const state = selectedActor(editor.store, editor.session);
      const own = ownNature(editor);
      if (state && own) editor.store.dispatch(resetNature(state, own.joint));
    },
  },
] as const satisfies readonly Command[];

/** The nature that a user gave to the selected joint. */
function ownNature({ store, session }: Editor) {
  const own = selectedActor(store, session)?.natures.own ?? [];
  return own.find(({ joint }) => joint === session.selectedJoint.value);
}

function toggleNatural({ store, session, notice }: Editor): void {
  const state = selectedActor(store, session);
  if (!state) return;
  const isOn = !state.natures.isOn;
  store.dispatch(setNatural(state.id, isOn));
  notice.value = isOn
    ? 'Inverse kinematics bends joints as they do by nature'
    : 'Inverse kinematics bends joints in any way that the file allows';
}

function toggleMode({ session, notice }: Editor): void {
  toggle(session.ikMode);
  notice.value = session.ikMode.value
    ? 'Inverse kinematics: a drag on a limb moves its whole chain'
    : 'A drag on a limb turns its joint alone';
}

/** Changes the chain of the joint that is dragged, or else of the selected one. */
function stepLength({ store, session, evaluations, notice }: Editor, step: 1 | -1): void {
  const skeleton = selectedActor(store, session)?.character.skeleton;
  const joint = session.shownChain.value?.joints.at(-1) ?? session.selectedJoint.value;
  if (!skeleton || joint === null) return;
  changeChainLength({ session, evaluations }, joint, step);
  const { count } = chainLengthOf({ session, evaluations }, joint);
  const joints = count === 1 ? 'joint' : 'joints';
  notice.value = `The chain to ${skeleton.names[joint]!} has ${count} ${joints}`;
}
