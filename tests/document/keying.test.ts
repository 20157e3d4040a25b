import { describe, expect, it } from 'vitest';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import { setKey } from '../../src/core/motion/edit/set-key.ts';
import { channelKey } from '../../src/core/motion/targets.ts';
import { axisDofs } from '../../src/core/pose.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import {
  addClip,
  duplicateClip,
  emptyClip,
  releaseClip,
  removeClip,
  renameClip,
  setClipFps,
  setClipRange,
} from '../../src/document/clip-edits.ts';
import { jointTurn } from '../../src/document/joint-turn.ts';
import { keyValues } from '../../src/document/keying.ts';
import type { ShownState } from '../../src/document/keying-targets.ts';
import { type Actor, createActor, emptyScene, type Scene } from '../../src/document/scene.ts';
import type { Edit } from '../../src/document/edit.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { withMorph } from '../fixtures/with-morph.ts';

const character = withMorph(characterOfRig(rotatedTree()));
const { skeleton } = character;
const ballAt = [...skeleton.dofKind].indexOf(DofKind.ball);
const hinge = skeleton.names.flatMap((_, joint) =>
  axisDofs(skeleton, joint).filter(({ kind }) => kind === DofKind.hinge),
)[0]!;
const pin = {
  joint: 1,
  point: [0, 0, 0],
  place: [1, 2, 3],
  rotation: null,
  weight: 0.5,
  follows: null,
} as const;

const sceneOf = (actor: Actor): Scene => ({ ...emptyScene, actors: [actor] });
const after = (edit: Edit, actor: Actor): Actor => edit.apply(sceneOf(actor)).actors[0]!;
const nothing = { values: [], morphs: [], pins: [] };

const start = createActor(1, character, 'linear-blend', { pins: [pin] });
const shown: ShownState = {
  q: start.q.map((value, at) => value + 0.01 * at),
  morphWeights: Float64Array.of(0.75),
  pins: [pin],
};

describe('keying', () => {
  it('makes a clip with the first key, and binds it', () => {
    const what = { ...nothing, values: [hinge.index] };
    const actor = after(keyValues(start, 0, 0, shown, what, 'Key'), start);
    expect(actor).toMatchObject({ clip: 0, unkeyed: null });
    const [clip] = actor.clips;
    expect(clip).toMatchObject({ name: 'Motion', start: 0, end: 2, fps: 30 });
    expect(clip!.channels.map(({ target }) => channelKey(target!))).toHaveLength(1);
    expect(clip!.channels[0]!.keys).toEqual([
      { time: 0, value: shown.q[hinge.index], tangentIn: 'auto', tangentOut: 'auto' },
    ]);
  });

  it('sets what is shown: values, morphs and pins are the same at that time', () => {
    const what = {
      values: [...shown.q.keys()].filter((at) => skeleton.qMin[at] !== skeleton.qMax[at]),
      morphs: [0],
      pins: [1],
    };
    const { clips } = after(keyValues(start, 0, 0.5, shown, what, 'Key'), start);
    const values = {
      q: shown.q.slice(),
      morphWeights: new Float64Array(1),
      pins: new Float64Array(skeleton.jointCount * 4),
    };
    evaluateClip(clipFor(clips[0]!, character), 0.5, values);
    const clamped = shown.q.map((value, at) =>
      Math.min(Math.max(value, skeleton.qMin[at]!), skeleton.qMax[at]!),
    );
    values.q.forEach((value, at) => expect(value).toBeCloseTo(clamped[at]!, 12));
    expect(values.morphWeights[0]).toBe(0.75);
    expect([...values.pins.subarray(4, 8)]).toEqual([1, 2, 3, 0.5]);
  });

  it('keys a ball by one squad curve, whichever of its numbers changed', () => {
    if (ballAt < 0) return;
    const index = skeleton.dofQ[ballAt]!;
    const what = { ...nothing, values: [index + 2] };
    const unkeyed = { time: 0, ...nothing, values: [index + 1, index + 2] };
    const bound = { ...start, clips: [emptyClip([])], clip: 0, unkeyed };
    const actor = after(keyValues(bound, 0, 0, shown, what, 'Key'), bound);
    expect(actor.clips[0]!.channels).toHaveLength(1);
    expect(actor.clips[0]!.channels[0]!.target).toMatchObject({ of: 'rotation', curve: 'squad' });
    expect(actor.unkeyed, 'the whole ball is keyed').toBeNull();
    const joint = skeleton.names.findIndex((_, j) => skeleton.dofStart[j + 1]! > ballAt);
    expect(actor.clips[0]!.channels[0]!.keys[0]!.value).toEqual(
      jointTurn(skeleton, shown.q, joint),
    );
  });

  it('keys a hinge by the rotation, if the clip has a curve of the joint’s rotation', () => {
    const joint = skeleton.names.findIndex((_, j) => skeleton.dofStart[j + 1]! > hinge.dof);
    const source = skeleton.sourceIndex[joint]!;
    const target = { of: 'rotation', joint: source, curve: 'slerp' } as const;
    const clip = setKey(emptyClip([]), target, 0, [0, 0, 0, 1]);
    const bound = { ...start, clips: [clip], clip: 0 };
    const what = { ...nothing, values: [hinge.index] };
    const { channels } = after(keyValues(bound, 0, 1, shown, what, 'Key'), bound).clips[0]!;
    expect(channels).toHaveLength(1);
    expect(channels[0]!.target).toBe(target);
    expect(channels[0]!.keys[1]!.value).toEqual(jointTurn(skeleton, shown.q, joint));
  });

  it('lengthens the clip for a key outside its range', () => {
    const what = { ...nothing, morphs: [0] };
    const bound = { ...start, clips: [emptyClip([])], clip: 0 };
    const range = (time: number) => {
      const { start, end } = after(keyValues(bound, 0, time, shown, what, 'Key'), bound).clips[0]!;
      return [start, end];
    };
    expect([range(1), range(3), range(-1)]).toEqual([
      [0, 2],
      [0, 3],
      [-1, 2],
    ]);
  });
});

describe('the clips of a character', () => {
  const three = ['a', 'b', 'c'].map((name) => ({ ...emptyClip([]), name }));
  const bound = { ...start, clips: three, clip: 1 };

  it('are added, copied and named without two of one name', () => {
    const added = after(addClip(bound, shown), bound);
    expect(added).toMatchObject({ clip: 3, unkeyed: null });
    expect(added.q, 'what was shown stays').toBe(shown.q);
    const copied = after(duplicateClip(bound, 1), bound);
    expect([copied.clip, copied.clips[3]!.name]).toEqual([3, 'b 2']);
    expect(after(duplicateClip(bound, 0), bound).clip).toBe(1);
    expect(after(renameClip(bound, 1, 'wave'), bound).clips[1]!.name).toBe('wave');
  });

  it('keep the bound one when another is deleted, and the pose when it is itself', () => {
    const bind = (index: number) => after(removeClip(bound, index, shown), bound);
    expect([bind(0).clip, bind(2).clip, bind(1).clip]).toEqual([0, 1, null]);
    expect(bind(1).q).toBe(shown.q);
    expect(bind(0).clips[0]).toBe(three[1]);
    expect(after(releaseClip(bound, shown), bound)).toMatchObject({ clip: null, q: shown.q });
  });

  it('have their length and their frames a second, and stay if nothing changes', () => {
    const range = after(setClipRange(bound, 1, 1, 3), bound).clips[1]!;
    expect([range.start, range.end]).toEqual([1, 3]);
    expect(after(setClipFps(bound, 1, 24), bound).clips[1]!.fps).toBe(24);
    expect(after(setClipFps(bound, 1, 30), bound)).toBe(bound);
    expect(() => after(setClipRange(bound, 1, 1, 1), bound)).toThrow();
  });
});
