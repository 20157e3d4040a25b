import fc from 'fast-check';
import { bonesOf } from '../../src/core/bones.ts';
import { describe, expect, it } from 'vitest';
import { selectedJoints } from '../../src/document/selected-joints.ts';
import { toggleJoint } from '../../src/document/select-joints.ts';
import { removeActor, resetJoints, setPose } from '../../src/document/edits.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import type { Scene } from '../../src/document/scene.ts';
import { selectedActor } from '../../src/document/selected-actor.ts';
import { reconcile, selectActor } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { jointOfValue } from '../../src/core/pose.ts';
import { ancestorsOf } from '../../src/ui/joint-rows.ts';
import { hoveredOf } from '../../src/ui/hovered-limb.ts';
import { jointValues } from '../../src/ui/joint-values.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const characters = Object.values(allRigs).map((rig) => characterOfRig(rig()));

/** A store and a session that are connected by `keepTogether`. */
function start(keepTogether: (before: Scene, after: Scene, session: Session) => void) {
  const session = new Session();
  const store = new Store((before, after) => keepTogether(before, after, session));
  store.dispatch(openCharacter(null, characters[0]!, 'linear-blend'));
  return { store, session, gesture: store.begin('nothing') };
}

type Walk = ReturnType<typeof start>;

const stateOf = ({ store, session }: Walk) => selectedActor(store, session)!;

/** The next action of a user; the number chooses among the possible targets. */
const actions: readonly ((walk: Walk, number: number) => void)[] = [
  (walk, number) => {
    const character = characters[number % characters.length]!;
    walk.store.dispatch(openCharacter(stateOf(walk).id, character, 'rigid'));
  },
  ({ store }, number) => {
    const { actors } = store.scene.value;
    if (actors.length > 4) return;
    store.dispatch(openCharacter(null, characters[number % characters.length]!, 'linear-blend'));
  },
  ({ store, session }, number) => {
    const { actors } = store.scene.value;
    selectActor(session, store.scene.value, actors[number % actors.length]!.id);
  },
  (walk) => {
    if (walk.store.scene.value.actors.length > 1) walk.store.dispatch(removeActor(stateOf(walk)));
  },
  (walk, number) => {
    const { skeleton } = stateOf(walk).character;
    walk.session.selectedJoint.value = number % skeleton.jointCount;
  },
  (walk, number) => {
    const bones = bonesOf(stateOf(walk).character);
    const bone = bones[number % bones.length];
    if (!bone) return;
    walk.session.hoveredLimb.value = { actorId: stateOf(walk).id, joint: bone.joint, bone };
    walk.session.hoverPlace.value = [1, 1];
  },
  (walk, number) => {
    const { skeleton } = stateOf(walk).character;
    const joint = number % skeleton.jointCount;
    const value = jointValues(skeleton, joint)[0];
    if (value) {
      const { index, isAngle } = value;
      walk.session.activeDof.value = {
        name: skeleton.names[joint]!,
        index,
        isAngle,
        isChosen: true,
      };
    }
  },
  (walk, number) => {
    const state = stateOf(walk);
    walk.gesture = walk.store.begin('turn');
    walk.gesture.preview(
      setPose(
        state.id,
        state.q.map((value) => value + number),
      ),
    );
  },
  (walk) => walk.gesture.commit(),
  ({ store }) => void store.cancelGesture(),
  (walk, number) => {
    const state = stateOf(walk);
    walk.store.dispatch(
      resetJoints(state, state.q, [number % state.character.skeleton.jointCount], 'reset'),
    );
  },
  (walk, number) => toggleJoint(walk.session, number % stateOf(walk).character.skeleton.jointCount),
  ({ store }, number) => store.goTo(number % 8),
  ({ store }) => store.undo(),
  ({ store }) => store.undo(),
  ({ store }) => store.redo(),
];

const steps = fc.array(fc.tuple(fc.nat(actions.length - 1), fc.nat(1000)), { maxLength: 60 });

/** What every panel assumes when it reads both. */
function expectFits(walk: Walk): void {
  expect(stateOf(walk)).toBeDefined();
  const { character } = stateOf(walk);
  const { skeleton, clips } = character;
  const { selectedJoint, activeDof, clipIndex } = walk.session;
  const limb = hoveredOf(walk.session);
  const selected = selectedJoints(walk.session);
  expect(new Set(selected).size).toBe(selected.length);
  expect(selected[0] ?? null).toBe(selectedJoint.value);
  for (const joint of [...selected, limb?.joint ?? null]) {
    if (joint === null) continue;
    expect(joint).toBeLessThan(skeleton.jointCount);
    expect(ancestorsOf(skeleton, joint).length).toBe(skeleton.depths[joint]);
  }
  if (limb?.bone) expect(bonesOf(character)).toContain(limb.bone);
  const dof = activeDof.value;
  if (dof) expect(dof.name).toBe(skeleton.names[jointOfValue(skeleton, dof.index)]);
  expect(clipIndex.value).toBeLessThan(Math.max(1, clips.length));
}

function walks(
  keepTogether: (before: Scene, after: Scene, session: Session) => void,
  numRuns: number,
): void {
  fc.assert(
    fc.property(steps, (chosen) => {
      const walk = start(keepTogether);
      for (const [action, number] of chosen) {
        actions[action]!(walk, number);
        expectFits(walk);
      }
    }),
    { numRuns },
  );
}

describe('the session', () => {
  it('fits the scene after any run of opens, edits, selections, gestures and undos', () => {
    walks((before, after, session) => reconcile(session, before, after), 500);
  });

  it('does not fit without reconciling', () => {
    // Keeps an actor selected, so that only the joints do not match.
    const selectOnly = (_: Scene, { actors }: Scene, session: Session): void => {
      if (actors.some(({ id }) => id === session.selectedActorId.value)) return;
      session.selectedActorId.value = actors.at(-1)?.id ?? null;
    };
    expect(() => walks(selectOnly, 500)).toThrow();
  });

  it('drops the joint that undoing an opening removes, before anything reads it', () => {
    const walk = start((before, after, session) => reconcile(session, before, after));
    const largest = [...characters].sort(
      (a, b) => b.skeleton.jointCount - a.skeleton.jointCount,
    )[0]!;
    walk.store.dispatch(openCharacter(stateOf(walk).id, largest, 'linear-blend'));
    walk.session.selectedJoint.value = largest.skeleton.jointCount - 1;
    const seen: (number | null)[] = [];
    walk.store.scene.subscribe(() => void seen.push(walk.session.selectedJoint.peek()));
    walk.store.undo();
    expect(seen).toEqual([largest.skeleton.jointCount - 1, null]);
  });

  it('keeps the selection when a pose of the same joints is set and undone', () => {
    const walk = start((before, after, session) => reconcile(session, before, after));
    walk.session.selectedJoint.value = 1;
    const { id, q } = stateOf(walk);
    walk.store.dispatch(
      setPose(
        id,
        q.map((value) => value + 1),
      ),
    );
    walk.store.undo();
    expect(walk.session.selectedJoint.value).toBe(1);
  });
});
