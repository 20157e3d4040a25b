import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { type Pose, restPose } from '../../src/core/pose.ts';
import { convertCharacter } from '../../src/formats/convert.ts';
import { writeCse169 } from '../../src/formats/cse169/write-character.ts';
import { writeMit } from '../../src/formats/mit/write-character.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { linearBlend } from '../../src/skinning/linear-blend.ts';
import { skinVertices } from '../support/skin-vertices.ts';
import { leg, legSkel, legSkin } from '../support/cse169-files.ts';
import { largestDifference } from '../support/compare.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { shown } from '../support/diagnose.ts';
import { readOne } from '../support/files.ts';
import { randomBetween, randomSource } from '../support/random.ts';

function vertices(character: Character, pose: Pose): Float32Array {
  return skinVertices(character, character.skin, pose, linearBlend).positions;
}

function randomPose({ skeleton }: Character, seed: number): Pose {
  const random = randomSource(seed);
  const within = (low: number, high: number, value: number): number =>
    Math.min(Math.max(value, low), high);
  return {
    q: skeleton.qRest.map((_, i) =>
      within(skeleton.qMin[i]!, skeleton.qMax[i]!, randomBetween(random, -3, 3)),
    ),
  };
}

/**
 * Writes the character as the other course's files, with the pose as POSE.json, and reads them
 * again.
 */
async function through(character: Character, pose: Pose, to: 'mit' | 'cse169') {
  const converted = convertCharacter(character, to, pose);
  const files =
    to === 'mit' ? writeMit(converted.character).files : writeCse169(converted.character).files;
  const again = await readOne(Object.fromEntries(files.map(({ path, bytes }) => [path, bytes])));
  const json = poseToJson(converted.character.skeleton, converted.pose);
  const read = poseFromJson('p', json, again.skeleton);
  expect(read.diagnostics).toEqual([]);
  return { character: again, pose: read.value!, losses: shown(converted.losses) };
}

/** A body on the course's joints, with every point influenced by two of them. */
function course() {
  const joints = courseSkel.trimEnd().split('\n');
  const points = joints.map((_, i) => `v ${i % 3} ${5 - i / 3} ${(i * 7) % 5}`);
  const rows = joints.map((_, i) =>
    joints.slice(1).map((__, j) => (j === i % 17 ? 0.75 : j === (i * 5 + 1) % 17 ? 0.25 : 0)),
  );
  return readOne({
    'a.skel': courseSkel,
    'a.obj': [...points, 'f 1 2 3', 'f 4 5 6'].join('\n'),
    'a.attach': rows.map((row) => row.join(' ')).join('\n'),
  });
}

/** Bound rigidly at the skeleton's joints, like real skins, but with rotations. */
const rigidSkin = legSkin.replace(
  /bindings[^]*$/,
  `bindings 3 {
  matrix { 0 1 0  -1 0 0  0 0 1  0 1 0 }
  matrix { 0 1 0  0 0 1  1 0 0  0.5 1 0 }
  matrix { 1 0 0  0 1 0  0 0 1  0.6 1 -0.5 }
}`,
);

describe('convertCharacter', () => {
  it.each([1, 2, 3])(
    'carries a pose 6.837 → CSE169 → 6.837 and keeps every vertex: %#',
    async (seed) => {
      const mit = await course();
      const pose = randomPose(mit, seed);
      const there = await through(mit, pose, 'cse169');
      expect(there.losses).toEqual([]);
      const expected = vertices(mit, pose);
      expect(largestDifference(vertices(there.character, there.pose), expected)).toBeLessThan(1e-5);
      const back = await through(there.character, there.pose, 'mit');
      expect(largestDifference(vertices(back.character, back.pose), expected)).toBeLessThan(1e-5);
      expect([...back.character.skeleton.parents]).toEqual([...mit.skeleton.parents]);
    },
  );

  it.each([1, 2, 3])('carries a pose CSE169 → 6.837 → CSE169: %#', async (seed) => {
    const free = legSkel.replace(/ {2}rot.limit.*\n/g, '');
    const own = await readOne({ 'a.skel': free, 'a.skin': rigidSkin });
    const pose = randomPose(own, seed);
    const there = await through(own, pose, 'mit');
    const expected = vertices(own, pose);
    expect(largestDifference(vertices(there.character, there.pose), expected)).toBeLessThan(1e-5);
    const back = await through(there.character, there.pose, 'cse169');
    expect(largestDifference(vertices(back.character, back.pose), expected)).toBeLessThan(1e-5);
  });

  it('turns equal angles differently: numbers are not carried', async () => {
    const mit = await course();
    const pose = randomPose(mit, 4);
    const { pose: solved } = convertCharacter(mit, 'cse169', pose);
    expect(largestDifference(solved.q.toSorted(), pose.q.toSorted())).toBeGreaterThan(0.1);
  });

  it('puts a root before a first joint that has weights, and says what is lost', async () => {
    const own = await readOne({ ...leg, 'leg.skin': rigidSkin });
    const { character, losses } = convertCharacter(own, 'mit', restPose(own.skeleton));
    expect(character.skeleton.jointCount).toBe(4);
    expect([...character.skeleton.restOffsets.subarray(0, 3)]).toEqual([0, 0, 0]);
    const lost = shown(losses).join('\n');
    for (const word of ['root without weight', 'names of joints', 'boxes', 'bindings']) {
      expect(lost).toContain(word);
    }
    for (const word of ['limits of 3 values', '1 morphs', '1 clips', 'pose'])
      expect(lost).toContain(word);
  });

  it('says how far off a sheared binding is in 6.837', async () => {
    const own = await readOne(leg);
    const { losses } = convertCharacter(own, 'mit', restPose(own.skeleton));
    expect(shown(losses)[0]).toContain('matrices that are off by up to');
  });

  it('leaves a character that has the shape already as it is', async () => {
    const [mit, own] = [await course(), await readOne(leg)];
    expect(convertCharacter(mit, 'mit', restPose(mit.skeleton)).character).toBe(mit);
    expect(convertCharacter(own, 'cse169', restPose(own.skeleton)).character).toBe(own);
  });

  it('converts a skeleton alone and a mesh alone', async () => {
    const skeleton = await readOne({ 'a.skel': legSkel });
    const mesh = await readOne({ 'a.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3' });
    const there = await through(skeleton, restPose(skeleton.skeleton), 'mit');
    expect(there.character.skeleton.jointCount).toBe(3);
    expect((await through(mesh, restPose(mesh.skeleton), 'cse169')).character.mesh.pointCount).toBe(
      3,
    );
  });
});
