import { effect } from '@preact/signals-core';
import { setPose } from '../document/edits.ts';
import { ChainDrag, type ChainMoment } from '../posing/ik/chain-drag.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { attempt } from './attempt.ts';
import { chainLengthOf, changeChainLength } from './chain-length.ts';
import type { Looking, Telling } from './editor.ts';
import { type FrameClock, pageClock } from './frame-clock.ts';
import { heldGoals } from './held-goals.ts';
import { ikSolver, natureFinder } from './ik-solvers.ts';
import { fixedText } from './number-text.ts';

/** A point of the selected character that is held by the pointer. */
export interface HeldPoint {
  readonly joint: number;
  /** In the joint's frame. */
  readonly point: Vector3;
  /** The name of the step of undo. */
  readonly label: string;
  /** What the text in the view calls it. */
  readonly name: string;
}

/** A chain that is being dragged. */
export interface HeldChain {
  /** False after the drag was canceled or ended by an undo. */
  readonly isOpen: boolean;
  /** Says where the point is to go, in the character's space. */
  aim(place: Vector3): void;
  /** Adds joints to the chain, or takes some from it. */
  lengthen(step: number): void;
  end(): void;
  cancel(): void;
}

/**
 * Takes hold of a chain. Its pose follows from picture to picture, also while the pointer rests,
 * until the chain rests too. The whole drag is one step of undo.
 */
export function holdChain(
  editor: Looking & Telling,
  { joint, point, label, name }: HeldPoint,
  clock: FrameClock = pageClock,
): HeldChain {
  const { store, session, evaluations } = editor;
  const shown = evaluations.selected()!;
  const { state } = shown;
  const part = ikSolver(session.ikMethod.value);
  const start = {
    skeleton: state.character.skeleton,
    q: shown.poseToEdit.q.slice(),
    ...{ joint, point, held: heldGoals(shown) },
  };
  const gesture = store.begin(label);
  let hand: Vector3 | null = null;
  let drag: ChainDrag | null = null;
  let present: Float64Array = start.q;
  let stopFrames: (() => void) | null = null;
  const load = () => Promise.all([part.load(), natureFinder.load()]);
  attempt(editor, load());
  // A longer or shorter chain moves on although the pointer rests.
  const stopWatching = effect(() => {
    if (session.chainLength.value) wake();
  });

  return {
    get isOpen() {
      return gesture.isOpen;
    },
    aim(place) {
      hand = place;
      wake();
    },
    lengthen: (step) => changeChainLength(editor, joint, step),
    end() {
      if (!hand || (part.value && natureFinder.value)) complete();
      // The code arrives after a first drag that was short.
      else attempt(editor, load().then(complete, cancel));
    },
    cancel,
  };

  function wake(): void {
    if (!hand) return;
    drag?.aim(hand, clock.now());
    stopFrames ??= clock.everyFrame(draw);
  }

  function draw(seconds: number): void {
    if (!gesture.isOpen) {
      letGo();
      return;
    }
    const now = dragNow(seconds);
    if (!now) return;
    const moment = now.advance(seconds);
    show(now, moment);
    if (moment.isAtRest) sleep();
  }

  /** The drag with the chain's present length, as soon as there is code for it. */
  function dragNow(seconds: number): ChainDrag | null {
    const solver = part.value;
    const natures = natureFinder.value?.(state.character, state.natures);
    if (!solver || !natures || !hand) return null;
    const { count } = chainLengthOf(editor, joint);
    if (drag?.joints.length !== count) {
      drag = new ChainDrag({ ...start, natures, count, solver, seconds }, drag ? present : start.q);
      drag.aim(hand, seconds);
    }
    return drag;
  }

  function show({ joints }: ChainDrag, { q, target, isApart, residual }: ChainMoment): void {
    present = q;
    gesture.preview(setPose(state.id, q, label));
    session.shownChain.value = { actorId: state.id, joints, point, target, isApart };
    const length = `${joints.length} ${joints.length === 1 ? 'joint' : 'joints'}`;
    const apart = ` · ${fixedText(residual * shown.display.scale)} short of the pointer`;
    const keys = session.byTouch.value ? '' : ' · wheel: longer or shorter';
    session.dragText.value = `${name} · ${length}${isApart ? apart : keys}`;
  }

  function complete(): void {
    const now = gesture.isOpen ? dragNow(clock.now()) : null;
    if (now) show(now, now.finish());
    gesture.commit();
    letGo();
  }

  function cancel(): void {
    gesture.cancel();
    letGo();
  }

  function sleep(): void {
    stopFrames?.();
    stopFrames = null;
  }

  function letGo(): void {
    sleep();
    stopWatching();
    session.dragText.value = null;
    session.shownChain.value = null;
  }
}
