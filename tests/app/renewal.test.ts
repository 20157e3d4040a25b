import { describe, expect, it } from 'vitest';
import { influencesOf } from '../../src/core/skin.ts';
import { changedSkin } from '../../src/document/skin-edits.ts';
import { keptState, weightsText } from '../../src/app/renewal.ts';
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

  it('keep the weights that the user changed, on top of those of the files', () => {
    const rows = new Map([[1, [{ entry: 0, weight: 0.25 }]]]);
    const skin = changedSkin(plain, plain.skin, rows);
    const actor = createActor(1, plain, 'linear-blend', { skin });
    const weights = plain.skin.weights.map((weight) => weight * 0.5);
    const after = { ...plain, skin: { ...plain.skin, weights } };
    const kept = keptState(actor, after).skin!;
    expect(influencesOf(kept, 1)).toEqual(rows.get(1));
    expect(influencesOf(kept, 0)).toEqual(influencesOf(after.skin, 0));
    expect(weightsText(actor, after)).toBe(', changed weights too');
    expect(weightsText(createActor(1, plain, 'linear-blend'), after)).toBe('');
  });

  it('drop them, and say so, where the vertices are others', () => {
    const skin = changedSkin(plain, plain.skin, new Map([[0, [{ entry: 0, weight: 0.25 }]]]));
    const actor = createActor(1, plain, 'linear-blend', { skin });
    const after = { ...plain, mesh: { ...plain.mesh, pointCount: plain.mesh.pointCount - 1 } };
    expect(keptState(actor, after).skin).toBeNull();
    expect(weightsText(actor, after)).toMatch(/dropped/);
  });
});
