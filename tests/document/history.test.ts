import { describe, expect, it } from 'vitest';
import { createActor, emptyScene, type Scene } from '../../src/document/scene.ts';
import { emptyHistory, record, stepTo } from '../../src/document/history.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const character = characterOfRig(Object.values(allRigs)[0]!());

function documentWith(values: number): Scene {
  const kept = { q: new Float64Array(values), morphWeights: new Float64Array(0) };
  const state = createActor(1, character, 'linear-blend', kept);
  return { ...emptyScene, actors: [state] };
}

/** Steps of 80 bytes each: a pose of ten values. */
function historyOf(count: number, memoryLimit?: number) {
  let history = emptyHistory;
  for (let i = 0; i < count; i++) {
    const entry = { label: `${i}`, before: documentWith(10), after: documentWith(10) };
    history = record(history, entry, memoryLimit);
  }
  return history;
}

describe('the history', () => {
  it('lets the oldest steps go past its memory limit', () => {
    const labels = historyOf(10, 80 * 4).past.map(({ label }) => label);
    expect(labels).toEqual(['6', '7', '8', '9']);
  });

  it('keeps the newest step even where it alone is past the limit', () => {
    expect(historyOf(3, 10).past.map(({ label }) => label)).toEqual(['2']);
  });

  it('counts a character that a step replaced, not one that it shares', () => {
    const opened = {
      label: 'open',
      before: documentWith(1),
      after: emptyScene,
    };
    const posed = { label: 'pose', before: documentWith(1), after: documentWith(1) };
    const small = 200;
    expect(record(record(emptyHistory, posed, small), posed, small).past).toHaveLength(2);
    expect(record(record(emptyHistory, opened, small), posed, small).past).toHaveLength(1);
  });

  it('counts the curves that an edit replaced, and not those that the clip kept', () => {
    const key = { time: 0, value: 0, tangentIn: 'auto', tangentOut: 'auto' } as const;
    const channel = (keyCount: number) => ({
      target: null,
      before: 'constant' as const,
      after: 'constant' as const,
      keys: Array.from({ length: keyCount }, (_, at) => ({ ...key, time: at })),
    });
    const clip = { file: '', name: 'walk', start: 0, end: 1, fps: 30 };
    const sceneWith = (...channels: ReturnType<typeof channel>[]): Scene => {
      const actor = documentWith(0).actors[0]!;
      return { ...emptyScene, actors: [{ ...actor, clips: [{ ...clip, channels }] }] };
    };
    const [long, short] = [channel(1000), channel(1)];
    const step = (before: Scene, after: Scene) => ({ label: 'edit', before, after });
    const limit = 50_000;
    const fits = (first: ReturnType<typeof step>): boolean => {
      const next = step(sceneWith(long, short), sceneWith(long, channel(1)));
      return record(record(emptyHistory, first, limit), next, limit).past.length === 2;
    };
    expect(fits(step(sceneWith(long, channel(2)), sceneWith(long, short)))).toBe(true);
    expect(fits(step(sceneWith(channel(1000)), sceneWith(long, short)))).toBe(false);
  });

  it('counts all that a replaced character keeps alive: morphs, images and the weights in use too', () => {
    const kilobytes = (count: number) => new Uint8Array(count * 1024);
    const morph = { ...character.morphs[0]!, offsets: new Float32Array(4 * 256) };
    const image = { textures: [], name: 'a.png', bytes: kilobytes(8) };
    const heavy = { ...character, morphs: [morph], images: [image] };
    const actors = [createActor(1, heavy, 'linear-blend', { normalizeWeights: true })];
    const entry = { label: 'open', before: { ...emptyScene, actors }, after: emptyScene };
    const light = { label: 'pose', before: documentWith(1), after: documentWith(1) };
    const fits = (limit: number): boolean =>
      record(record(emptyHistory, entry, limit), light, limit).past.length === 2;
    const plain = {
      ...entry,
      before: { ...emptyScene, actors: [createActor(1, character, 'linear-blend')] },
    };
    const least = smallestLimit((limit) => {
      return record(record(emptyHistory, plain, limit), light, limit).past.length === 2;
    });
    const more = smallestLimit(fits) - least;
    expect(more).toBeGreaterThanOrEqual(12 * 1024 + character.skin.weights.byteLength);
  });

  it('steps back and forward to itself', () => {
    const history = historyOf(3);
    const [back] = stepTo(history, 1);
    expect([back.past.length, back.future.length]).toEqual([1, 2]);
    expect(stepTo(back, 3)[0]).toEqual(history);
  });
});

/** Finds a limit in bytes by bisection. */
function smallestLimit(fits: (limit: number) => boolean): number {
  let [low, high] = [0, 1 << 24];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (fits(middle)) high = middle;
    else low = middle;
  }
  return high;
}
