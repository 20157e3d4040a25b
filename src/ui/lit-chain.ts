import { effect } from '@preact/signals-core';
import { bonesOf } from '../core/bones.ts';
import { sameValue } from '../core/same-value.ts';
import type { ShownChain } from '../document/session.ts';
import { pathTo } from '../posing/ik/chain.ts';
import { attempt } from './attempt.ts';
import { chainLengthOf } from './chain-length.ts';
import type { Looking, Telling } from './editor.ts';
import { hoveredOf } from './hovered-limb.ts';
import { ikSolver, natureFinder } from './ik-solvers.ts';
import { isLive } from './live-limb.ts';

/**
 * Lights the chain that a drag would move while inverse kinematics is on: that of the limb under
 * the pointer, or else that of the selected joint. A drag shows its chain itself.
 */
export function followChains(editor: Looking & Telling): void {
  const { shownChain, ikMode, ikMethod } = editor.session;
  effect(() => {
    // The first drag should not wait for the code.
    if (ikMode.value) {
      attempt(editor, Promise.all([ikSolver(ikMethod.value).load(), natureFinder.load()]));
    }
    const isDragged = (shownChain.value?.target ?? null) !== null;
    if (isDragged) return;
    const lit = ikMode.value ? litChain(editor) : null;
    if (!sameValue(lit, shownChain.value)) shownChain.value = lit;
  });
}

function litChain(editor: Looking): ShownChain | null {
  const { session, evaluations } = editor;
  const state = evaluations.selected()?.state;
  const hovered = hoveredOf(session);
  const limb = hovered && isLive(editor, hovered) ? hovered : null;
  const joint = limb?.joint ?? session.selectedJoint.value;
  if (!state || joint === null) return null;
  const { character } = state;
  const { count } = chainLengthOf(editor, joint);
  const bone = limb?.bone ?? bonesOf(character).find((each) => each.joint === joint);
  return {
    actorId: state.id,
    joints: pathTo(character.skeleton, joint).slice(-count),
    point: bone?.joint === joint ? bone.vector : [0, 0, 0],
    target: null,
    isApart: false,
  };
}
