import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import { createActor, emptyScene, type Scene } from '../../../src/document/scene.ts';
import { Session } from '../../../src/document/session.ts';
import { Store } from '../../../src/document/store.ts';
import { replaceScene } from '../../../src/document/scene-edits.ts';
import { Evaluations } from '../../../src/evaluation/evaluations.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import { startCamera } from '../../../src/document/camera.ts';
import { frameTime } from '../../../src/view/movie/movie-plan.ts';
import { movieSource } from '../../../src/view/movie/movie-source.ts';
import type { Viewer } from '../../../src/view/viewer.ts';
import { planOf } from '../../app/movie/fake-source.ts';
import { readBundled } from '../../support/bundled.ts';
import { allThere, fullPool } from '../../support/kernels.ts';

/** What a movie's frames need of a viewer before they are drawn. */
function viewerOf(evaluations: Evaluations): Viewer {
  return {
    evaluations,
    available: signal(true),
    held: new Set(),
    requestFrame: () => undefined,
    texturesShown: () => Promise.resolve(),
  } as unknown as Viewer;
}

async function filmed(from: number) {
  const character = await readBundled('insect');
  const actor = createActor(1, character, 'linear-blend', { clip: 0 });
  const scene: Scene = { ...emptyScene, actors: [actor] };
  const [store, session] = [new Store(), new Session()];
  store.dispatch(replaceScene(scene, 'Scene'));
  session.selectedActorId.value = 1;
  session.clipTime.value = 0.3;
  const viewer = viewerOf(new Evaluations(store, session, allThere));
  const plan = planOf({ format: 'obj', range: 'typed', from, to: from + 1, rate: 30 });
  const contents = [{ camera: startCamera, overrides: {} }];
  return { actor, store, session, viewer, request: { plan, scene, contents } };
}

it('a frame is the moment of its own time exactly, in any order, whatever the page shows', async () => {
  const { actor, store, session, viewer, request } = await filmed(0.1);
  const source = await movieSource(viewer, session, request);
  const poses = new Set<string>();
  for (const index of [0, 29, 3, 3, 17]) {
    const frame = await source.frame(index);
    const alone = new Evaluator(actor, fullPool()).evaluate(actor, frameTime(request.plan, index));
    expect(frameTime(request.plan, index)).toBe(0.1 + index / 30);
    const { characterFromJoint } = frame.selected()!;
    expect(characterFromJoint).toEqual(alone.characterFromJoint);
    poses.add(characterFromJoint.join());
    // Neither edits nor the playhead of the page have to do with it.
    store.dispatch(replaceScene(emptyScene, 'Clear'));
    session.clipTime.value += 0.11;
  }
  expect(poses.size).toBe(4);
  expect(viewer.held.size).toBe(1);
  source.release();
  expect(viewer.held.size).toBe(0);
});

it('a frame leaves the page at its time', async () => {
  const { session, store, viewer, request } = await filmed(0.1);
  const shown = viewer.evaluations.of(store.scene.value.actors[0]!).pose.q.slice();
  const source = await movieSource(viewer, session, request);
  await source.frame(20);
  expect(session.clipTime.value).toBe(0.3);
  expect(viewer.evaluations.of(store.scene.value.actors[0]!).pose.q).toEqual(shown);
  source.release();
});

it('frames end when the work is canceled', async () => {
  const { session, viewer, request } = await filmed(0);
  const work = new AbortController();
  const source = await movieSource(viewer, session, request, work.signal);
  await source.frame(0);
  work.abort();
  await expect(source.frame(1)).rejects.toThrow('Canceled');
  source.release();
});
