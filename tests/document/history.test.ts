import { describe, expect, it } from 'vitest';
import { createActor, type Scene } from '../../src/document/scene.ts';
import { emptyHistory, record, stepBack, stepForward } from '../../src/document/history.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { allRigs } from '../fixtures/rigs.ts';

const character = characterOfRig(Object.values(allRigs)[0]!());

function documentWith(values: number): Scene {
  const kept = { q: new Float64Array(values), morphWeights: new Float64Array(0) };
  const state = createActor(1, character, 'linear-blend', kept);
  return { actors: [state] };
}

/** Steps of 80 bytes each: ten values of a pose. */
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
      after: { actors: [] },
    };
    const posed = { label: 'pose', before: documentWith(1), after: documentWith(1) };
    const small = 200;
    expect(record(record(emptyHistory, posed, small), posed, small).past).toHaveLength(2);
    expect(record(record(emptyHistory, opened, small), posed, small).past).toHaveLength(1);
  });

  it('steps back and forward to itself', () => {
    const history = historyOf(3);
    expect(stepForward(stepBack(history))).toEqual(history);
  });
});
