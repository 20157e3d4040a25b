import { signal } from '@preact/signals-core';
import { vec3 } from 'gl-matrix';
import { beforeEach, describe, expect, it } from 'vitest';
import { bonesOf } from '../../src/core/bones.ts';
import type { ChannelParts, ClipParts, Quaternion } from '../../src/core/motion/clip-parts.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { editActor } from '../../src/document/edit.ts';
import { openCharacter } from '../../src/document/open-characters.ts';
import { reconcile } from '../../src/document/reconcile.ts';
import { Session } from '../../src/document/session.ts';
import { Store } from '../../src/document/store.ts';
import { Transport } from '../../src/document/transport.ts';
import { Kernels } from '../../src/evaluation/kernels.ts';
import { poseLayers } from '../../src/posing/layers.ts';
import { aboutAxis } from '../../src/posing/charts/quaternions.ts';
import { conversionsOf } from '../../src/ui/rotation-lab/conversions.ts';
import { endPaths } from '../../src/ui/rotation-lab/end-paths.ts';
import { insertRotationKey, insertText } from '../../src/ui/rotation-lab/insert-rotation-key.ts';
import { type LabEditor, RotationLab } from '../../src/ui/rotation-lab/rotation-lab.ts';
import { storeAs } from '../../src/ui/rotation-lab/store-as.ts';
import { readBundled } from '../support/bundled.ts';

const human = await readBundled('human');
const { skeleton } = human;
const shoulder = skeleton.names.indexOf('Right shoulder');
const source = skeleton.sourceIndex[shoulder]!;
const plain = { file: '', name: 'test', start: 0, end: 2, fps: 30 };
const constant = { before: 'constant', after: 'constant' } as const;
/** Rounding of a path's points, in model units, where a character is about one unit tall. */
const rounding = 1e-6;

/** A spline of a hinge through values at the times 0, 1, 2, … */
function hinge(axis: 0 | 1 | 2, values: readonly number[]): ChannelParts {
  const keys = values.map((value, time) => {
    return { time, value, tangentIn: 'linear', tangentOut: 'linear' } as const;
  });
  return { target: { of: 'value', joint: source, kind: DofKind.hinge, axis }, ...constant, keys };
}

function rotation(curve: 'slerp' | 'squad', values: readonly Quaternion[]): ChannelParts {
  const keys = values.map((value, time) => ({ time, value }));
  return { target: { of: 'rotation', joint: source, curve }, ...constant, keys };
}

let editor: LabEditor;

/** Gives the human a clip. */
function play(...channels: readonly ChannelParts[]): void {
  const clip: ClipParts = {
    ...plain,
    end: Math.max(...channels.map(({ keys }) => keys.length - 1)),
    channels,
  };
  editor.store.dispatch(editActor(1, 'clip', (actor) => ({ ...actor, clips: [clip], clip: 0 })));
}

const clipNow = (): ClipParts => editor.store.scene.value.actors[0]!.clips[0]!;

beforeEach(() => {
  const session = new Session();
  const store = new Store((before, after) => reconcile(session, before, after));
  store.dispatch(openCharacter(null, human, 'linear-blend'));
  const transport = new Transport(store, session);
  editor = { store, session, transport, tab: signal('animate'), notice: signal('') };
  session.selectedJoint.value = shoulder;
});

describe('the rotation lab', () => {
  it('says why there is nothing to show', () => {
    const lab = new RotationLab(editor);
    play(hinge(0, [0, 1]));
    expect(lab.subject.value!.name).toBe('Right shoulder');
    editor.session.selectedJoint.value = skeleton.names.indexOf('Left shoulder');
    expect(lab.refusal.value).toMatch(/does not turn Left shoulder/);
    editor.session.selectedJoint.value = null;
    expect(lab.refusal.value).toMatch(/^Select a joint/);
    editor.store.dispatch(editActor(1, '', (actor) => ({ ...actor, clips: [], clip: null })));
    expect(lab.refusal.value).toMatch(/has no clip/);
    lab.dispose();
  });

  it('shows the stored angles as they are, 540° too, and the numbers at the playhead', () => {
    const lab = new RotationLab(editor);
    play(hinge(0, [0, 3 * Math.PI]));
    const { curves, motion } = lab.subject.value!;
    const [euler] = curves;
    const x = euler!.chart.names.indexOf('X');
    expect(motion.stored).toBe('euler');
    expect(euler!.values.at(-1)![x]).toBeCloseTo(3 * Math.PI, 9);
    editor.session.clipTime.value = 0.25;
    expect(lab.values.value[0]![x]).toBeCloseTo(0.75 * Math.PI, 9);
    lab.dispose();
  });

  it('computes charts and paths once for a clip, however often the time changes', () => {
    const lab = new RotationLab(editor);
    play(hinge(0, [0, 1]), hinge(1, [0, 1]));
    const before = [lab.subject.value, lab.conversions.value, editor.session.rotationPaths.value];
    editor.session.clipTime.value = 0.5;
    editor.store.dispatch(editActor(1, 'name', (actor) => ({ ...actor, name: 'Ada' })));
    const after = [lab.subject.value, lab.conversions.value, editor.session.rotationPaths.value];
    after.forEach((each, i) => expect(each).toBe(before[i]));
    editor.tab.value = 'pose';
    expect(editor.session.rotationPaths.value).toBeNull();
    lab.dispose();
  });

  it('stores by another curve in one step of undo, and says the largest difference', () => {
    play(hinge(0, [0, 1, 0.2]), hinge(1, [0.4, -0.3, 0.9]), hinge(2, [0, 0.5, 1]));
    const before = clipNow();
    storeAs(editor, 'squad');
    expect(editor.notice.value).toMatch(
      /^Right shoulder stored as squad; it differs by at most \d+(\.\d+)?° at \d\.\d\d s$/,
    );
    expect(clipNow().channels.map(({ target }) => target)).toEqual([
      { of: 'rotation', joint: source, curve: 'squad' },
    ]);
    storeAs(editor, 'squad');
    expect(editor.notice.value).toBe('Right shoulder is stored as squad already');
    editor.store.undo();
    expect(clipNow()).toBe(before);
  });

  it('says how much a new key will turn a squad, and a spline not at all', () => {
    const lab = new RotationLab(editor);
    play(hinge(0, [0, 1, 0.2]), hinge(1, [0.4, -0.3, 0.9]));
    expect(insertText(lab.subject.value!, 0.6)).toBe('does not change the motion');
    storeAs(editor, 'squad');
    expect(insertText(lab.subject.value!, 0.6)).toMatch(
      /^turns the curve by at most \d+(\.\d+)?°$/,
    );
    editor.session.clipTime.value = 0.6;
    insertRotationKey(editor);
    expect(clipNow().channels[0]!.keys.map(({ time }) => time)).toEqual([0, 0.6, 1, 2]);
    expect(editor.notice.value).toMatch(/inserting it turns the curve/);
    insertRotationKey(editor);
    expect(editor.notice.value).toMatch(/^There is a key of Right shoulder at 0.60 s already/);
    lab.dispose();
  });
});

describe('the paths of the bone’s end', () => {
  it('are an arc of a circle for two keys about one axis, by slerp', async () => {
    const kernels = new Kernels();
    await kernels.layer(poseLayers[0]!).load();
    const axis = [0.6, 0, 0.8];
    play(rotation('slerp', [aboutAxis(axis, -0.2), aboutAxis(axis, 0.3)]));
    const lab = new RotationLab(editor);
    const subject = lab.subject.value!;
    const found = endPaths(subject, conversionsOf(subject), kernels);
    const { points, keys, isStored } = found.find(({ curve }) => curve === 'slerp')!;
    expect(isStored).toBe(true);
    expect(keys).toEqual([points[0], points.at(-1)]);
    const { vector } = bonesOf(human).find(({ joint }) => joint === shoulder)!;
    const along = vec3.dot(vector, axis);
    const radius = Math.sqrt(vec3.squaredLength(vector) - along * along);
    // The chord between neighbors is that of the same angle everywhere: 0.5 rad in equal parts.
    const chord = 2 * radius * Math.sin(0.25 / (points.length - 1));
    points.slice(1).forEach((point, i) => {
      expect(Math.abs(vec3.distance([...point], [...points[i]!]) - chord)).toBeLessThan(rounding);
    });
    const whole = vec3.distance([...points[0]!], [...points.at(-1)!]);
    expect(Math.abs(whole - 2 * radius * Math.sin(0.25))).toBeLessThan(rounding);
    lab.dispose();
  });
});
