import { rayInFrame } from '../core/ray.ts';
import { keyMovedPose } from '../document/key-pose.ts';
import { selectActor } from '../document/reconcile.ts';
import { actorById } from '../document/scene.ts';
import type { Moments } from '../evaluation/moments.ts';
import { chainLength } from '../posing/ik/chain.ts';
import { ChainDrag } from '../posing/ik/chain-drag.ts';
import type { Vector3 } from '../posing/ik/problem.ts';
import { slideOnPlane } from '../posing/slide.ts';
import { axesOf } from '../view/camera.ts';
import { characterRayAt } from '../view/pick.ts';
import type { TrailHandle } from '../view/trail-shapes.ts';
import { attempt } from './attempt.ts';
import type { Looking, Telling } from './editor.ts';
import { heldGoals } from './held-goals.ts';
import { ikSolver, natureFinder } from './ik-solvers.ts';
import { fixedText } from './number-text.ts';
import { distanceBetween, stillDistance, type ToolDrag, type ToolPlace } from './tool.ts';

/**
 * Drags a key of a trail: the pose at the key's time reaches to the pointer by inverse kinematics,
 * and is keyed there. The view goes to that time. A drag depends only on its start and on where the
 * pointer is.
 */
export function dragTrailKey(
  editor: Looking & Telling,
  moments: Moments,
  from: ToolPlace,
  { trail, time, place }: TrailHandle,
): ToolDrag {
  const { store, session, viewer } = editor;
  selectActor(session, store.scene.value, trail.actorId);
  const actor = actorById(store.scene.value, trail.actorId)!;
  session.clipTime.value = time;
  const moment = moments.at('drag', actor, time);
  const before = { ...moment.snapshot(), pins: moment.pins };
  const { skeleton } = actor.character;
  const { joint, point } = trail;
  const start = { skeleton, q: before.q, joint, point, held: heldGoals(moment) };
  moments.keepOnly(['trail']);
  const count = chainLength(skeleton, joint, session.chainLength.value, actor.pins);
  const around = neighbors(
    trail.keys.map((key) => key.time),
    time,
    [trail.frames[0]!.time, trail.frames.at(-1)!.time],
  );
  const limb = skeleton.names[joint]!;
  const label = `Move ${limb} at ${fixedText(time)} s`;
  const part = ikSolver(session.ikMethod.value);
  const load = Promise.all([part.load(), natureFinder.load()]);
  const gesture = store.begin(label);
  const { look } = axesOf(viewer.viewCamera.value);
  const ray = { origin: [0, 0, 0], direction: look } as const;
  const across = rayInFrame(ray, trail.sceneFromCharacter).direction;
  const grabbed = characterRayAt(editor, from);
  let hand: Vector3 | null = null;
  let moved = false;
  attempt(editor, load);

  return {
    move({ place: to }) {
      moved ||= distanceBetween(from, to) > stillDistance;
      if (!moved) return;
      const by = slideOnPlane([...place], across, grabbed, characterRayAt(editor, to));
      if (!by) return;
      hand = [place[0] + by[0], place[1] + by[1], place[2] + by[2]];
      reach();
    },
    end() {
      // The code arrives after a first drag that was short.
      if (hand && !isLoaded()) attempt(editor, load.then(finish, cancel));
      else finish();
    },
    cancel,
  };

  function isLoaded(): boolean {
    return part.value !== undefined && natureFinder.value !== undefined;
  }

  function reach(): void {
    const [solver, find] = [part.value, natureFinder.value];
    if (!solver || !find || !hand || !gesture.isOpen) return;
    const natures = find(actor.character, actor.natures);
    const drag = new ChainDrag({ ...start, natures, count, solver, seconds: 0 });
    drag.aim(hand, 0);
    const { q } = drag.finish();
    gesture.preview(keyMovedPose(actor, { time, before, q, around }, label));
    session.dragText.value = `${limb} at ${fixedText(time)} s`;
  }

  function finish(): void {
    reach();
    gesture.commit();
    session.dragText.value = null;
  }

  function cancel(): void {
    gesture.cancel();
    session.dragText.value = null;
  }
}

/** The nearest times before and after one, or the ends where there is none. */
function neighbors(
  times: readonly number[],
  time: number,
  [start, end]: readonly [number, number],
): readonly number[] {
  const before = times.findLast((each) => each < time) ?? start;
  const after = times.find((each) => each > time) ?? end;
  return [before, after].filter((each) => each !== time);
}
