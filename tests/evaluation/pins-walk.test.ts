import { expect, it } from 'vitest';
import { DofKind } from '../../src/core/skeleton.ts';
import { removeActor, resetPose, setPose, setValue } from '../../src/document/edits.ts';
import { follows } from '../../src/document/followers.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import {
  followJoint,
  holdPlace,
  holdRotation,
  movePin,
  pinJoints,
  setPinWeight,
  unpinJoints,
  whyNoFollowing,
} from '../../src/document/pin-edits.ts';
import { setTransform } from '../../src/document/place-edits.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { writeScene } from '../../src/document/scene-json/write-scene.ts';
import { sameScene, type Scene, unmoved } from '../../src/document/scene.ts';
import { Session } from '../../src/document/session.ts';
import { type Gesture, Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { settlePins } from '../../src/evaluation/settle-pins.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';
import { allThere } from '../support/kernels.ts';
import { randomSource } from '../support/random.ts';

const characters = Object.values(allRigs)
  .map((rig) => characterOfRig(rig()))
  .filter(({ skeleton }) => skeleton.jointCount > 2);

class Walk {
  readonly session = new Session();
  readonly store = new Store((before, after) => reconcile(this.session, before, after));
  readonly evaluations = new Evaluations(this.store, this.session, allThere);
  readonly random: () => number;
  gesture: Gesture | null = null;

  constructor(seed: number) {
    this.random = randomSource(seed);
    this.store.settle = (scene) => settlePins(scene, this.evaluations);
    this.add(); // it is no step of undo
  }

  below(count: number): number {
    return Math.floor(this.random() * count);
  }

  around(): number {
    return 2 * this.random() - 1;
  }

  one<T>(list: readonly T[]): T | undefined {
    return list[this.below(list.length)];
  }

  add(): void {
    this.store.dispatch(openCharacter(null, this.one(characters)!, 'linear-blend'));
  }

  shown() {
    return this.evaluations.of(this.one(this.store.scene.value.actors)!);
  }
}

/** What a user does next. */
const actions: readonly ((walk: Walk) => void)[] = [
  (walk) => {
    if (walk.store.scene.value.actors.length < 4) walk.add();
  },
  (walk) => {
    const { actors } = walk.store.scene.value;
    if (actors.length > 2) walk.store.dispatch(removeActor(walk.one(actors)!));
  },
  (walk) => {
    const shown = walk.shown();
    walk.store.dispatch(pinJoints(shown, [walk.below(shown.state.character.skeleton.jointCount)]));
  },
  (walk) => {
    const { state } = walk.shown();
    const pin = walk.one(state.pins);
    if (pin) walk.store.dispatch(unpinJoints(state, [pin.joint]));
  },
  (walk) => {
    const { state } = walk.shown();
    const pin = walk.one(state.pins);
    if (pin) walk.store.dispatch(setPinWeight(state, pin.joint, walk.one([0, 0.3, 1])!));
  },
  (walk) => {
    const shown = walk.shown();
    const pin = walk.one(shown.state.pins);
    if (pin) walk.store.dispatch(holdRotation(shown, pin.joint, walk.random() < 0.5));
  },
  (walk) => {
    const { state } = walk.shown();
    const pin = walk.one(state.pins);
    if (!pin) return;
    const [x, y, z] = pin.place;
    walk.store.dispatch(movePin(state, pin.joint, [x + walk.around(), y, z + walk.around()]));
  },
  (walk) => {
    const shown = walk.shown();
    const pin = walk.one(shown.state.pins);
    if (pin) walk.store.dispatch(holdPlace(shown, pin.joint));
  },
  (walk) => {
    const [own, other] = [walk.shown(), walk.shown()];
    const reason = whyNoFollowing(walk.store.scene.value, own.state.id, other.state.id);
    if (reason !== null) return;
    const joint = walk.below(own.state.character.skeleton.jointCount);
    const followed = {
      actor: other.state.id,
      joint: walk.below(other.state.character.skeleton.jointCount),
      point: [0, 0, 0] as const,
      rotation: unmoved.rotation,
    };
    walk.store.dispatch(followJoint(own, joint, [0, 0, 0], followed, 'Follow'));
  },
  (walk) => {
    const { state } = walk.shown();
    const position = [walk.around(), 0, walk.around()] as const;
    walk.store.dispatch(setTransform(state.id, { ...unmoved, position }, 'Move'));
  },
  (walk) => {
    const { state, poseToEdit } = walk.shown();
    const start = poseToEdit.q.slice();
    const { dofQ, dofKind } = state.character.skeleton;
    const index = walk.one([...dofQ].filter((_, dof) => dofKind[dof] !== DofKind.ball));
    if (index === undefined) return;
    walk.gesture = walk.store.begin('Turn');
    for (let i = 0; i < 2; i++) {
      walk.gesture.preview(setValue(state.id, start, index, 0.5 * walk.around(), 'Turn'));
      for (const each of walk.evaluations.all())
        expect(each.pose.q.every(Number.isFinite)).toBe(true);
    }
  },
  ({ gesture }) => gesture?.commit(),
  ({ gesture }) => gesture?.cancel(),
  (walk) => walk.store.dispatch(resetPose(walk.shown().state.id)),
  (walk) => {
    const { state, poseToEdit } = walk.shown();
    walk.store.dispatch(setPose(state.id, poseToEdit.q));
  },
  ({ store }) => void store.undo(),
  ({ store }) => void store.redo(),
];

/** Nobody follows itself, directly or through others. */
function expectNoCircle(scene: Scene): void {
  for (const { id, pins } of scene.actors) {
    for (const pin of pins) {
      if (pin.follows) expect(follows(scene, pin.follows.actor, id)).toBe(false);
    }
  }
}

it('500 random commands and gestures with pins are undone and redone, the scene byte for byte', () => {
  const walk = new Walk(14);
  const { store } = walk;
  const first = store.scene.value;
  const text = writeScene(first);
  for (let step = 0; step < 500; step++) {
    walk.one(actions)!(walk);
    expectNoCircle(store.scene.value);
  }
  walk.gesture?.commit();
  const last = store.scene.value;
  while (store.undo() !== null);
  expect(sameScene(store.scene.value, first)).toBe(true);
  expect(writeScene(store.scene.value)).toBe(text);
  while (store.redo() !== null);
  expect(sameScene(store.scene.value, last)).toBe(true);
});
