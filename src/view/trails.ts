import { computed, effect, type ReadonlySignal } from '@preact/signals-core';
import { motionViewOf } from '../document/motion-view.ts';
import { type Actor, boundClip } from '../document/scene.ts';
import { selectedActor } from '../document/selected-actor.ts';
import { selectedJoints } from '../document/selected-joints.ts';
import type { Session } from '../document/session.ts';
import type { Store } from '../document/store.ts';
import { Moments } from '../evaluation/moments.ts';
import { Trails } from '../evaluation/trails.ts';
import { timeInClip } from '../posing/playhead.ts';
import { addPassBefore } from './add-pass.ts';
import { overlayDrawer, overlayViewOf } from './passes/overlay.ts';
import { type PlacedTrail, trailShapes } from './trail-shapes.ts';
import type { Viewer } from './viewer.ts';

/** Trails in the view, and the moments of which they are made. */
export interface ShownTrails {
  readonly trails: ReadonlySignal<readonly PlacedTrail[]>;
  readonly moments: Moments;
}

/** Shows trails whenever the session asks for them. */
export function showTrails(viewer: Viewer, store: Store, session: Session): ShownTrails {
  const moments = new Moments(store, session, viewer.evaluations);
  const computer = new Trails(moments);
  const trails = computed(() => {
    const actors = trailActors(store, session);
    const found = actors.flatMap(([actor, joints]) => trailsOf(actor, joints));
    computer.keepOnly(actors.map(([{ id }]) => id));
    if (found.length === 0) moments.keepOnly([]);
    return found;
  });
  addPassBefore(viewer, 'overlay', {
    id: 'trails',
    isShown: ({ showOverlay }) => showOverlay && trails.value.length > 0,
    create: overlayDrawer((frame, cssScale) =>
      trailShapes(trails.peek(), overlayViewOf(frame, cssScale), frame.options.hoveredHandle),
    ),
  });
  let hadTrails = false;
  effect(() => {
    const hasTrails = trails.value.length > 0;
    if (hasTrails || hadTrails) viewer.requestFrame();
    hadTrails = hasTrails;
  });
  return { trails, moments };

  function trailsOf(actor: Actor, joints: readonly number[]): readonly PlacedTrail[] {
    const clip = boundClip(actor)!;
    const present = timeInClip(clip, session.clipTime.value, session.playMode.value);
    const { sceneFromCharacter } = viewer.evaluations.of(actor).display;
    const settings = motionViewOf(session).trails.value;
    return computer
      .of(actor, joints, settings, present)
      .map((trail) => ({ ...trail, sceneFromCharacter, present }));
  }
}

/** The actors that show trails, and of which joints. */
function trailActors(store: Store, session: Session): (readonly [Actor, readonly number[]])[] {
  const { trails, trailJoints } = motionViewOf(session);
  if (!trails.value.isOn) return [];
  const selected = selectedActor(store, session);
  return store.scene.value.actors
    .filter((actor) => boundClip(actor) && actor.look.visible)
    .map((actor): readonly [Actor, readonly number[]] => {
      const pinned = trailJoints.value.filter(({ actorId }) => actorId === actor.id);
      const own = actor === selected ? selectedJoints(session) : [];
      const joints = new Set([...pinned.map(({ joint }) => joint), ...own]);
      const { jointCount } = actor.character.skeleton;
      return [actor, [...joints].filter((joint) => joint < jointCount)];
    })
    .filter(([, joints]) => joints.length > 0);
}
