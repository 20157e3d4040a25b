import { describe, expect, it } from 'vitest';
import { keptState } from '../../src/app/renewal.ts';
import { createActor } from '../../src/document/scene.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';

const plain = characterOfRig(rotatedTree());
const clip = { file: 'a.anim', start: 0, end: 1, fps: 30, channels: [] };
const named = (...names: string[]) => names.map((name) => ({ ...clip, name }));

const before = { ...plain, clips: named('walk', 'run') };

describe('files that are read again', () => {
  it('bring their clips where the user changed none, and the bound one stays bound', () => {
    const after = { ...plain, clips: named('jump', 'run') };
    const actor = createActor(1, before, 'linear-blend', { clip: 1 });
    expect(keptState(actor, after)).toMatchObject({ clips: after.clips, clip: 1 });
  });

  it("keep the user's clips beside those that are new in the files", () => {
    const after = { ...plain, clips: named('jump', 'run', 'walk') };
    const own = { ...before.clips[0]!, name: 'stroll' };
    const edited = { ...before.clips[1]!, end: 3 };
    const actor = createActor(1, before, 'linear-blend', { clips: [edited, own], clip: 1 });
    const kept = keptState(actor, after);
    expect(kept.clips).toEqual([edited, own, after.clips[0]]);
    expect(kept.clip).toBe(1);
  });

  it('leave what is unkeyed as it is while the clip stays bound', () => {
    const unkeyed = { time: 0.5, values: [1], morphs: [], pins: [] };
    const actor = { ...createActor(1, before, 'linear-blend', { clip: 1 }), unkeyed };
    expect(keptState(actor, { ...plain, clips: named('run') }).unkeyed).toBe(unkeyed);
    expect(keptState(actor, { ...plain, clips: named('walk') }).unkeyed).toBeUndefined();
  });
});
