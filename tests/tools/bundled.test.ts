import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { extents } from '../../src/core/bounds.ts';
import type { Character } from '../../src/core/character.ts';
import { clipFor, evaluateClip } from '../../src/core/motion/clip.ts';
import type { Pose } from '../../src/core/pose.ts';
import type { PoseList } from '../../src/app/bundled-poses.ts';
import { displayTransform } from '../../src/evaluation/display-transform.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { bundledIds, catalogue, readBundled } from '../support/bundled.ts';
import { expectPosable, expectSound } from '../support/check-character.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { clipValues } from '../support/clip-values.ts';

const folder = join(import.meta.dirname, '../../public/data');
const kilobyte = 1000;

const fileOf = (path: string): Buffer => readFileSync(join(folder, path));
const textOf = (path: string): string => gunzipSync(fileOf(path)).toString('utf8');
const sizeOf = (paths: readonly string[]): number =>
  paths.reduce((sum, path) => sum + statSync(join(folder, path)).size, 0);

function entryOf(id: string) {
  return catalogue.characters.find((entry) => entry.id === id)!;
}

function poseOf(path: string, { skeleton }: Character): Pose {
  const json = JSON.parse(fileOf(path).toString('utf8')) as unknown;
  const { value, diagnostics } = poseFromJson(path, json, skeleton);
  expect(diagnostics).toEqual([]);
  return value!;
}

function posedPoints(character: Character, pose: Pose): Float32Array {
  return skinVertices(character, character.skin, pose, linearBlend).positions;
}

function pictureOf(poses: string): string {
  return poses.replace(/json$/, 'webp');
}

function bottomOf(positions: Float32Array): number {
  return positions.reduce((low, value, i) => (i % 3 === 1 ? Math.min(low, value) : low), Infinity);
}

describe.each(bundledIds)('the bundled character %s', (id) => {
  it('has exactly the files that the catalogue lists, and is sound', async () => {
    const { files, pose, poses, motions = [] } = entryOf(id);
    const ofPoses = poses === undefined ? [] : [poses, pictureOf(poses)];
    const listed = [
      ...files,
      ...(pose === undefined ? [] : [pose]),
      ...ofPoses,
      ...motions,
    ].toSorted();
    const found = readdirSync(join(folder, id)).filter((name) => name !== 'LICENSE.txt');
    expect(listed).toEqual(found.map((name) => `${id}/${name}`).toSorted());
    const character = await readBundled(id);
    expectSound(character);
    expectPosable(character);
    expect(character.missing).toEqual([]);
    expect(character.name).toBe(id);
    if (pose !== undefined) poseOf(pose, character);
  });

  it('has a defined material for every run of triangles, if it has materials', async () => {
    const { mesh, materials } = await readBundled(id);
    if (materials.length === 0) return;
    const names = materials.map(({ name }) => name).toSorted();
    expect([...new Set(mesh.submeshes.map(({ material }) => material))].toSorted()).toEqual(names);
  });

  it('has rows of weights whose decimals sum to exactly 1', () => {
    const path = entryOf(id).files.find((file) => file.endsWith('.attach.gz'));
    if (path === undefined) return;
    const rows = textOf(path).trimEnd().split('\n');
    const sums = new Set(
      rows.map((row) =>
        row
          .trim()
          .split(' ')
          .reduce((sum, weight) => sum + Math.round(Number(weight) * 1000), 0),
      ),
    );
    expect([...sums]).toEqual([1000]);
    expect(rows.join('')).not.toMatch(/\.\d{4}/);
  });
});

describe('the first visit', () => {
  const scene = catalogue.scenes[0]!;
  const filesOf = (id: string): readonly string[] => entryOf(id).files;

  it('shows characters that are small enough', () => {
    const poses = scene.actors.map(({ pose }) => pose);
    expect(sizeOf([...filesOf('human'), poses[0]!])).toBeLessThan(250 * kilobyte);
    const all = scene.actors.flatMap(({ character }) => filesOf(character));
    expect(sizeOf([...all, ...poses])).toBeLessThan(700 * kilobyte);
  });

  it('is a scene in which all stand on the floor, with true sizes', async () => {
    const unitsPerMeter = new Set<string>();
    for (const { character: id, pose, place } of scene.actors) {
      const character = await readBundled(id);
      expect(Math.abs(bottomOf(posedPoints(character, poseOf(pose, character))))).toBeLessThan(
        1e-3,
      );
      unitsPerMeter.add((displayTransform(character).scale * place.scale).toFixed(3));
    }
    expect(unitsPerMeter.size).toBe(1);
  });

  it('is a scene in which the paw lies in the hand, and nothing else touches', async () => {
    const [person, dog] = await Promise.all(scene.actors.map(inScene));
    const hand = membersOf(person!.character, /^Right (hand|palm|fingers|thumb)$/);
    const paw = membersOf(dog!.character, /^Left front (foot|toes)$/);
    const gaps = { hand: Infinity, elsewhere: Infinity };
    for (const [a, b] of nearPairs(person!.points, dog!.points)) {
      const gap = vec3.distance(person!.points[a]!, dog!.points[b]!) / person!.unitsPerMeter;
      const part = hand.has(a) && paw.has(b) ? 'hand' : 'elsewhere';
      gaps[part] = Math.min(gaps[part], gap);
    }
    expect(gaps.hand).toBeLessThan(0.01);
    expect(gaps.elsewhere).toBeGreaterThan(0.01);
  });

  async function inScene({ character: id, pose, place }: (typeof scene.actors)[number]) {
    const character = await readBundled(id);
    const { sceneFromCharacter, scale } = displayTransform(character, {
      transform: {
        position: [place.x, 0, place.z],
        rotation: [0, Math.sin(place.turn / 2), 0, Math.cos(place.turn / 2)],
        scale: place.scale,
      },
    });
    const positions = posedPoints(character, poseOf(pose, character));
    const points = Array.from({ length: character.mesh.pointCount }, (_, point) =>
      vec3.transformMat4(
        vec3.create(),
        positions.subarray(point * 3, point * 3 + 3),
        Float32Array.from(sceneFromCharacter),
      ),
    );
    return { character, points, unitsPerMeter: scale };
  }

  /** Pairs of points in the same or neighboring cells of a grid. */
  function nearPairs(a: readonly vec3[], b: readonly vec3[]): [number, number][] {
    const cell = 0.02;
    const keyOf = (point: vec3, shift: readonly number[]): string =>
      shift.map((by, axis) => Math.floor(point[axis]! / cell) + by).join(' ');
    const cells = new Map<string, number[]>();
    for (const [index, point] of b.entries()) {
      const key = keyOf(point, [0, 0, 0]);
      cells.set(key, [...(cells.get(key) ?? []), index]);
    }
    const around = [-1, 0, 1].flatMap((x) =>
      [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z])),
    );
    return a.flatMap((point, index) =>
      around.flatMap((shift) =>
        (cells.get(keyOf(point, shift)) ?? []).map((other): [number, number] => [index, other]),
      ),
    );
  }

  /** The points that follow joints of such names. */
  function membersOf({ skin, skeleton, mesh }: Character, names: RegExp): Set<number> {
    const members = new Set<number>();
    for (let point = 0; point < mesh.pointCount; point++) {
      for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
        const name = skeleton.names[skin.paletteJoint[skin.entries[i]!]!]!;
        if (names.test(name)) members.add(point);
      }
    }
    return members;
  }
});

describe('the bundled human', () => {
  it('has a face: eyes with iris and pupil behind each other, lips and brows at their places', async () => {
    const { mesh, materials } = await readBundled('human');
    const boxes = new Map(
      mesh.submeshes.map(({ material, firstIndex, indexCount }) => {
        const corners = mesh.indices.subarray(firstIndex, firstIndex + indexCount);
        const along = (axis: number) => Array.from(corners, (v) => mesh.positions[v * 3 + axis]!);
        return [
          material,
          [0, 1, 2].map((axis) => ({
            low: Math.min(...along(axis)),
            high: Math.max(...along(axis)),
          })),
        ] as const;
      }),
    );
    const [eyes, irises, pupils] = ['eyes', 'irises', 'pupils'].map((name) => boxes.get(name)!);
    const [brows, lips] = ['brows', 'lips'].map((name) => boxes.get(name)!);
    for (const [x, y, z] of boxes.values()) {
      expect(x!.low + x!.high).toBeCloseTo(0, 2);
      expect([y, z]).toBeDefined();
    }
    expect(pupils![2]!.low).toBeGreaterThan(irises![2]!.low);
    expect(irises![2]!.low).toBeGreaterThan(eyes![2]!.low);
    expect(pupils![1]!.high).toBeLessThan(irises![1]!.high);
    expect(irises![1]!.high).toBeLessThan(eyes![1]!.high);
    expect(brows![1]!.low).toBeGreaterThan(pupils![1]!.high);
    expect(lips![1]!.high).toBeLessThan(eyes![1]!.low);
    const sizeOfLips = [0, 1].map((axis) => lips![axis]!.high - lips![axis]!.low);
    expect(sizeOfLips[0]).toBeGreaterThan(0.04);
    expect(sizeOfLips[1]).toBeLessThan(0.03);
    // The skin is clay, whose color the app chooses.
    expect(materials.find(({ name }) => name === 'skin')?.colors).toBeUndefined();
    expect(materials.filter(({ colors }) => colors).length).toBe(materials.length - 1);
  });
});

describe('the bundled panda', () => {
  it('walks in place in a cycle, with its paws near the floor', async () => {
    const panda = await readBundled('panda');
    const [clip] = panda.clips;
    const compiled = clipFor(clip!, panda);
    const period = 2;
    const pointsAt = (time: number): Float32Array => {
      const values = clipValues(panda);
      evaluateClip(compiled, time, values);
      return posedPoints(panda, { q: values.q });
    };
    const [, height] = extents(panda.bounds);
    for (let time = 0; time < period; time += period / 16) {
      expect(Math.abs(bottomOf(pointsAt(time)))).toBeLessThan(0.06 * height);
    }
    const [first, last] = [pointsAt(0.1), pointsAt(0.1 + period)];
    const differences = first.map((value, i) => Math.abs(value - last[i]!));
    expect(Math.max(...differences)).toBeLessThan(1e-5);
  });
});

describe.each(['human', 'hand'])('the poses of the bundled %s', (id) => {
  const path = entryOf(id).poses!;
  const { joints, poses } = JSON.parse(fileOf(path).toString('utf8')) as PoseList;

  it('are eight, which differ, fit its joints and stand on the floor', async () => {
    const character = await readBundled(id);
    const { names } = character.skeleton;
    expect(new Set(poses.map(({ name }) => name)).size).toBe(8);
    for (const name of joints ?? []) expect(names).toContain(name);
    const height = extents(character.bounds)[1];
    const seen = poses.map(({ name, pose }) => {
      const { value, diagnostics } = poseFromJson(path, pose, character.skeleton);
      expect(diagnostics, name).toEqual([]);
      for (const joint of Object.keys(pose.joints ?? {})) expect(joints ?? names).toContain(joint);
      // A runner leaves the floor, and a hand is turned at its wrist.
      const points = posedPoints(character, value!);
      expect(Math.abs(bottomOf(points)) / height, name).toBeLessThan(0.1);
      return points;
    });
    for (const [index, one] of seen.entries()) {
      for (const other of seen.slice(0, index)) {
        const farthest = one.reduce(
          (most, each, i) => Math.max(most, Math.abs(each - other[i]!)),
          0,
        );
        expect(farthest / height).toBeGreaterThan(0.1);
      }
    }
  });

  it('have a picture each, one below the other, in a small file', () => {
    const picture = fileOf(pictureOf(path));
    expect(picture.length).toBeLessThan(25 * kilobyte);
    expect(picture.subarray(8, 12).toString('latin1')).toBe('WEBP');
    // The extended form has 24-bit sizes less one (RFC 9649, 2.7).
    expect(picture.subarray(12, 16).toString('latin1')).toBe('VP8X');
    const [width, height] = [picture.readUIntLE(24, 3) + 1, picture.readUIntLE(27, 3) + 1];
    expect(height).toBe(width * poses.length);
  });
});
