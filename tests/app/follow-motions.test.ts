import { signal } from '@preact/signals-core';
import { expect, it, vi } from 'vitest';
import { MotionFollower } from '../../src/app/follow-motions.ts';
import type { SceneParts } from '../../src/app/scenes/scene-parts.ts';
import type { Character } from '../../src/core/character.ts';
import type { ClipParts } from '../../src/core/motion/clip-parts.ts';
import { addClip, renameClip } from '../../src/document/clip-edits.ts';
import { openCharacters } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Evaluations } from '../../src/evaluation/evaluations.ts';
import { shownState } from '../../src/evaluation/shown-state.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

const clip = { file: 'a.anim', start: 0, end: 1, fps: 30, channels: [] };
const motions: readonly ClipParts[] = ['walk', 'wave'].map((name) => ({ ...clip, name }));
const completed = new Set<Character>();

vi.mock('../../src/app/bundled-motions.ts', () => ({
  lacksMotions: (_: unknown, character: Character) => !completed.has(character),
  withMotions: (_: unknown, character: Character) => {
    const full = { ...character, clips: [...character.clips, ...motions] };
    completed.add(full);
    return Promise.resolve(full);
  },
}));

/** A bundled character with a clip, before its motions come. */
function open() {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  const evaluations = new Evaluations(store, session);
  const character = { ...characterOfRig(rotatedTree()), clips: [{ ...clip, name: 'nod' }] };
  const kept = { source: { kind: 'bundled', id: 'tree' } } as const;
  store.dispatch(openCharacters([], [{ character, method: 'linear-blend', kept }]));
  const follow = (): Promise<void> => {
    const opening = { store, session, notice: signal('') };
    const opener = { keep: () => undefined, filesOf: () => [] };
    const parts = { opening, opener, entryOf: () => ({ motions: ['walk.json'] }) };
    return new MotionFollower(parts as unknown as SceneParts).whenDone();
  };
  const actor = () => store.scene.value.actors[0]!;
  const names = () => actor().clips.map(({ name }) => name);
  return { store, evaluations, actor, names, follow };
}

it('brings a character its motions without a step of undo', async () => {
  const { store, names, actor, follow } = open();
  await follow();
  expect(names()).toEqual(['nod', 'walk', 'wave']);
  expect(actor().clips).toBe(actor().character.clips);
  expect(store.undoLabel.value).toBeNull();
});

it('adds them after clips that somebody changed or made meanwhile, and after an undo too', async () => {
  const { store, evaluations, names, actor, follow } = open();
  store.dispatch(renameClip(actor(), 0, 'bow'));
  store.dispatch(addClip(actor(), shownState(evaluations.selected()!)));
  const bound = actor().clip;
  const following = follow();
  await following;
  expect(names()).toEqual(['bow', 'Motion', 'walk', 'wave']);
  expect(actor().clip).toBe(bound);
  expect(store.history.value.past).toHaveLength(2);
  store.undo();
  await vi.waitFor(() => expect(names()).toEqual(['bow', 'walk', 'wave']));
  expect(store.history.value.past).toHaveLength(1);
});

it('leaves out a motion whose name a clip has', async () => {
  const { store, names, actor, follow } = open();
  store.dispatch(renameClip(actor(), 0, 'wave'));
  await follow();
  expect(names()).toEqual(['wave', 'walk']);
});
