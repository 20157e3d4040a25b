import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { beforeAll, describe, expect, it } from 'vitest';
import { evaluateChannel } from '../../src/core/motion/channel.ts';
import type { Character } from '../../src/core/character.ts';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { axisDofs } from '../../src/core/pose.ts';
import { DofKind } from '../../src/core/skeleton.ts';
import { insectJoints } from '../../tools/characters/insect/parts.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { catalogue } from '../support/bundled.ts';
import { type FileContents, readContents } from '../support/files.ts';
import { componentVolumes } from '../support/component-volumes.ts';
import { clipValues } from '../support/clip-values.ts';

const dataFolder = join(import.meta.dirname, '../../public/data');
const folder = join(dataFolder, 'insect');

/** The files as the page receives them: unpacked. */
const files: FileContents = Object.fromEntries(
  readdirSync(folder).map((name) => {
    const bytes = readFileSync(join(folder, name));
    return [name.replace(/\.gz$/, ''), name.endsWith('.gz') ? gunzipSync(bytes) : bytes];
  }),
);

let insect: Character;
beforeAll(async () => {
  const { characters, diagnostics } = await readContents(files);
  expect(diagnostics).toEqual([]);
  expect(characters).toHaveLength(1);
  insect = characters[0]!.character;
});

const jointsOf = (pattern: RegExp): Set<number> =>
  new Set(insect.skeleton.names.flatMap((name, joint) => (pattern.test(name) ? [joint] : [])));

/** The joints that move a point. */
function movers(point: number): number[] {
  const { start, entries, paletteJoint } = insect.skin;
  return Array.from(entries.subarray(start[point], start[point + 1]), (at) => paletteJoint[at]!);
}

describe('the bundled insect', () => {
  it('is what the catalogue says, and small', () => {
    const listed = catalogue.characters.find(({ id }) => id === 'insect')?.files ?? [];
    expect(listed.map((path) => path.replace('insect/', '')).toSorted()).toEqual(
      readdirSync(folder).toSorted(),
    );
    const sizes = listed.map((path) => statSync(join(dataFolder, path)).size);
    expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThan(350 * 1024);
  });

  it('is a whole character with two morphs, a walk and a texture', () => {
    expectSound(insect);
    expectPosable(insect);
    expect(insect.missing).toEqual([]);
    expect(insect.skeleton.jointCount).toBe(39);
    expect(insect.morphs.map(({ name }) => name)).toEqual(['insect_alert', 'insect_breathe']);
    expect(insect.clips.map(({ name }) => name)).toEqual(['insect_walk']);
    expect(insect.materials).toEqual([{ name: 'insect', texture: 'insect.png' }]);
    const { width, height } = PNG.sync.read(Buffer.from(files['insect.png'] as Uint8Array));
    expect([width, height]).toEqual([1024, 1024]);
  });

  it('has closed surfaces that look outwards', () => {
    const volumes = componentVolumes(insect.mesh);
    // Thorax, abdomen, head; two eyes, mandibles, antennae, wings with a vein each; six legs and
    // feet.
    expect(volumes).toHaveLength(3 + 2 * 5 + 6 * 2);
    for (const volume of volumes) expect(volume).toBeGreaterThan(0);
  });

  it('has weights of two joints or three at bends, which sum to one', () => {
    const { start, weights } = insect.skin;
    const used = new Set<number>();
    for (let point = 0; point < insect.mesh.pointCount; point++) {
      const row = weights.subarray(start[point], start[point + 1]);
      expect(row.length).toBeLessThanOrEqual(4);
      expect(row.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1, 6);
      for (const joint of movers(point)) used.add(joint);
    }
    expect(used.size).toBe(insect.skeleton.jointCount);
  });

  it('is bound with limbs turned along their frames, not at the zero pose', () => {
    const { skeleton, skin } = insect;
    const q = new Float64Array(skeleton.qRest.length);
    insectJoints.forEach(({ bind }, joint) => {
      for (const { kind, axis, index } of axisDofs(skeleton, joint)) {
        if (kind === DofKind.hinge) q[index] = bind[axis];
      }
    });
    const bound = jointMatrices(skeleton, q);
    const off = skin.bindFromJoint!.map((value, i) => Math.abs(value - bound[i]!));
    expect(Math.max(...off)).toBeLessThan(1e-5);
    const zero = jointMatrices(skeleton, new Float64Array(q.length));
    const turned = skin.bindFromJoint!.map((value, i) => Math.abs(value - zero[i]!));
    expect(Math.max(...turned)).toBeGreaterThan(0.5);
  });

  it('has limits everywhere, hinges locked but about one axis, and keeps to them', () => {
    const { skeleton, clips } = insect;
    for (let joint = 0; joint < skeleton.jointCount; joint++) {
      const free = axisDofs(skeleton, joint).filter(({ kind, index }) => {
        if (kind !== DofKind.hinge) return false;
        const [least, rest, most] = [skeleton.qMin, skeleton.qRest, skeleton.qMax].map(
          (values) => values[index]!,
        );
        expect(Math.max(-least!, most!)).toBeLessThan(3.2);
        expect(rest).toBeGreaterThanOrEqual(least!);
        expect(rest).toBeLessThanOrEqual(most!);
        return least! < most!;
      });
      if (/femur|tibia/.test(skeleton.names[joint]!)) {
        expect(free.map(({ axis }) => axis)).toEqual([2]);
      }
    }
    const clip = clipFor(clips[0]!, insect);
    expect(clip.curves.q.length).toBe(clips[0]!.channels.length);
    for (const { channel, minimum, maximum } of clip.curves.q) {
      for (let time = 0; time < 1.6; time += 0.01) {
        const value = evaluateChannel(channel, time);
        expect(value).toBeGreaterThanOrEqual(minimum);
        expect(value).toBeLessThanOrEqual(maximum);
      }
    }
  });

  it('has boxes around what follows each joint', () => {
    const boxes = insect.skeleton.displayBoxes!;
    for (let joint = 0; joint < insect.skeleton.jointCount; joint++) {
      for (let axis = 0; axis < 3; axis++) {
        const size = boxes[joint * 6 + 3 + axis]! - boxes[joint * 6 + axis]!;
        expect(size).toBeGreaterThan(0);
        expect(size).toBeLessThan(1);
      }
    }
  });

  it('breathes with its abdomen and is alert with its head', () => {
    const [alert, breathe] = insect.morphs;
    const abdomen = jointsOf(/^(abdomen|body)/);
    const head = jointsOf(/^(mandible|antenna)/);
    for (const vertex of breathe!.vertices) {
      for (const joint of movers(vertex)) expect(abdomen).toContain(joint);
    }
    for (const vertex of alert!.vertices) {
      for (const joint of movers(vertex)) expect(head).toContain(joint);
    }
    const largest = (offsets: Float32Array): number => Math.max(...offsets.map(Math.abs));
    expect(largest(breathe!.offsets)).toBeGreaterThan(0.02);
    expect(largest(alert!.offsets)).toBeGreaterThan(0.2);
  });
});

/** The tips of the feet in the character's space: left and right of each pair. */
function feet(q: Float64Array): [number, number, number][] {
  const world = jointMatrices(insect.skeleton, q);
  return [...jointsOf(/tarsus/)].map((joint) => {
    // A left foot points along +x of its frame, a right one along -x.
    const [min, max] = [joint * 6, joint * 6 + 3].map((i) => insect.skeleton.displayBoxes![i]!);
    const tip = max! > -min! ? max! : min!;
    const frame = world.subarray(joint * 16, joint * 16 + 16);
    return [0, 1, 2].map((i) => frame[i]! * tip + frame[12 + i]!) as [number, number, number];
  });
}

describe('the walk of the bundled insect', () => {
  const bodyLength = 1.8;
  /** How far the tip of a standing foot may be above where it was set down. */
  const down = 0.012;

  it('begins where the insect stands: feet on the floor', () => {
    for (const [, y] of feet(insect.skeleton.qRest)) expect(Math.abs(y - 0.008)).toBeLessThan(1e-3);
  });

  it('goes on three feet or more, each fixed to the floor while it stands', () => {
    const clip = clipFor(insect.clips[0]!, insect);
    const values = clipValues(insect);
    const standing = new Map<number, [number, number, number][]>();
    const drifts: number[] = [];
    const lift = (foot: number): void => {
      const places = standing.get(foot) ?? [];
      standing.delete(foot);
      const drift = [0, 1, 2].map((axis) => {
        const values = places.map((place) => place[axis]!);
        return Math.max(...values) - Math.min(...values);
      });
      if (places.length > 0) drifts.push(Math.hypot(...drift));
    };
    for (let step = 0; step <= 400; step++) {
      evaluateClip(clip, step * 0.008, values);
      const tips = feet(values.q);
      tips.forEach((tip, foot) => {
        expect(tip[1]).toBeGreaterThan(0);
        if (tip[1] < down) standing.set(foot, [...(standing.get(foot) ?? []), tip]);
        else lift(foot);
      });
      expect(tips.filter(([, y]) => y < down).length).toBeGreaterThanOrEqual(3);
    }
    expect(drifts.length).toBeGreaterThan(20);
    expect(Math.max(...drifts)).toBeLessThan(0.01 * bodyLength);
  });

  it('takes the body forward, as far in each cycle', () => {
    const clip = clipFor(insect.clips[0]!, insect);
    const values = clipValues(insect);
    const root = axisDofs(insect.skeleton, 0).find(
      ({ kind, axis }) => kind === DofKind.slide && axis === 2,
    );
    const far = [0, 0.8, 4].map((time) => {
      evaluateClip(clip, time, values);
      return values.q[root!.index]!;
    });
    expect(far[0]).toBeCloseTo(0, 9);
    expect(far[1]).toBeCloseTo(0.46, 9);
    expect(far[2]).toBeCloseTo(5 * 0.46, 9);
  });
});
