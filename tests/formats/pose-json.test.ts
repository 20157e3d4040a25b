import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { hasErrors } from '../../src/core/diagnostics.ts';
import { emptySkeleton } from '../../src/core/build-skeleton.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import type { Skeleton } from '../../src/core/skeleton.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { readPoseJson } from '../../src/formats/read-pose-json.ts';
import { characterOfRig } from '../fixtures/character-of-rig.ts';
import { rotatedTree } from '../fixtures/rigs.ts';
import { largestDifference } from '../support/compare.ts';
import { courseSkel } from '../support/course-skeleton.ts';
import { shown } from '../support/diagnose.ts';
import { readOne } from '../support/files.ts';
import { squarePmd } from '../support/pmd-files.ts';

const { skeleton } = await readOne({ 'a.skel': courseSkel });

function q(json: unknown, of: Skeleton = skeleton): number[] {
  const { value, diagnostics } = readPoseJson('p.json', JSON.stringify(json), of);
  expect(diagnostics).toEqual([]);
  return [...value!.q];
}

function messages(text: string, of: Skeleton = skeleton): string[] {
  const { value, diagnostics } = readPoseJson('p.json', text, of);
  expect(value).toBeUndefined();
  return shown(diagnostics);
}

/**
 * The values of the course's skeleton: three slides and three hinges of the root, then three hinges
 * per joint.
 */
const rest = new Array<number>(3 + 18 * 3).fill(0);

describe('readPoseJson', () => {
  it('keeps the pose of the file for an empty pose', () => {
    expect(q({})).toEqual(rest);
    expect(q({ joints: {} })).toEqual(rest);
    const rig = characterOfRig(rotatedTree()).skeleton;
    expect(q({ joints: {} }, rig)).toEqual([...rig.qRest]);
    expect(rig.qRest.some((value) => value !== 0)).toBe(true);
  });

  it('sets angles by name and by index, and the displacement of the root', () => {
    const posed = rest.with(0, 0.1).with(1, 0.2).with(2, 0.3);
    const root = q({ root: [0.1, 0.2, 0.3], joints: { Root: [1, 2, 3] } });
    expect(root).toEqual(posed.with(3, 1).with(4, 2).with(5, 3));
    // In depth-first order, "Waist" is the third joint and "Left foot", #11 in the file, the
    // eleventh.
    expect(q({ joints: { Waist: [4, 5, 6] } })).toEqual(rest.with(9, 4).with(10, 5).with(11, 6));
    const foot = skeleton.names.indexOf('Left foot');
    const byIndex = q({ joints: { '#11': [7, 8, 9] } });
    expect(byIndex.slice(3 + foot * 3, 6 + foot * 3)).toEqual([7, 8, 9]);
    expect(byIndex).toEqual(q({ joints: { 'Left foot': [7, 8, 9] } }));
  });

  it('takes a byte order mark and angles past a full turn', () => {
    const { value } = readPoseJson('p.json', '\uFEFF{"joints":{"Root":[100,0,-100]}}', skeleton);
    expect([...value!.q.slice(3, 6)]).toEqual([100, 0, -100]);
  });

  it('moves the root of lowest index in the file', async () => {
    const forest = (await readOne({ 'a.skel': '0 0 0 1\n0 0 0 -1\n0 0 0 -1\n' })).skeleton;
    expect(q({ root: [1, 2, 3] }, forest).slice(0, 3)).toEqual([1, 2, 3]);
    expect(q({ root: [1, 2, 3], joints: { '#1': [4, 5, 6] } }, forest).slice(3, 6)).toEqual([
      4, 5, 6,
    ]);
  });

  it.each([
    ['[]', ':1:1', 'an object with "joints" and "root", found "[]" [pose/json]'],
    ['null', ':1:1', 'an object with "joints" and "root", found "null" [pose/json]'],
    ['{"joint":{}}', ':1:2 (joint)', '"joints" or "root", found "joint" [pose/unknown]'],
    ['{"joints":[]}', ':1:11 (joints)', '"joints" to be an object, found "[]" [pose/json]'],
    ['{"root":[1,2]}', ':1:9 (root)', 'three numbers for "root", found "[1,2]" [pose/json]'],
    ['{"root":null}', ':1:9 (root)', 'three numbers for "root", found "null" [pose/json]'],
    [
      '{"joints":{"Neck":[1,2,"3"]}}',
      ':1:24 (joints.Neck[2])',
      'three numbers for "Neck", found "[1,2,"3"]" [pose/json]',
    ],
    [
      '{"joints":{"Neck":[1,2,1e999]}}',
      ':1:24 (joints.Neck[2])',
      'three numbers for "Neck", found "[1,2,null]" [pose/json]',
    ],
    [
      '{"joints":{"Tail":[0,0,0]}}',
      ':1:12 (joints.Tail)',
      'the name of a joint, or # and its index, found "Tail" [pose/unknown-joint]',
    ],
    [
      '{"joints":{"neck":[0,0,0]}}',
      ':1:12 (joints.neck)',
      'the name of a joint, or # and its index ("Neck"?), found "neck" [pose/unknown-joint]',
    ],
    [
      '{"joints":{"#18":[0,0,0]}}',
      ':1:12 (joints."#18")',
      'a joint from #0 to #17, found "#18" [pose/unknown-joint]',
    ],
    [
      '{"joints":{"__proto__":[0,0,0]}}',
      ':1:12 (joints.__proto__)',
      'the name of a joint, or # and its index, found "__proto__" [pose/unknown-joint]',
    ],
    [
      '{"version":2,"joint":{}}',
      ':1:12 (version)',
      '"version" to be 1 (a newer Sinew wrote this), found "2" [pose/version]',
    ],
    ['{"version":"1"}', ':1:12 (version)', '"version" to be 1, found ""1"" [pose/json]'],
    [
      '{\r\n "joints": {\r\n  "骨 é": [0, 0, 0]}}',
      ':3:3 (joints."骨 é")',
      'the name of a joint, or # and its index, found "骨 é" [pose/unknown-joint]',
    ],
    [
      '{"joints": {\n  "Left elbow": [0, "1", 0]}}',
      ':2:21 (joints."Left elbow"[1])',
      'three numbers for "Left elbow", found "[0,"1",0]" [pose/json]',
    ],
  ])('refuses %s', (text, place, message) => {
    expect(messages(text)).toEqual([
      `error: p.json${place}: expected ${message}; the pose is not used`,
    ]);
  });

  it.each([
    ['{"root":[0,1.1e18,0]}', ':1:12 (root[1])', '"root"', '[0,1100000000000000000,0]'],
    ['{"joints":{"Neck":[1e300,0,0]}}', ':1:20 (joints.Neck[0])', '"Neck"', '[1e+300,0,0]'],
  ])('refuses %s, past what can be computed with', (text, place, what, found) => {
    expect(messages(text)).toEqual([
      `error: p.json${place}: expected numbers within ±1e18 for ${what}, found "${found}" [pose/range]; ` +
        'the pose is not used',
    ]);
  });

  it('clamps to the limits of a joint and tells both values', () => {
    const limited = { ...skeleton, qMin: skeleton.qMin.slice(), qMax: skeleton.qMax.slice() };
    const x = 3; // the root's first hinge, after its slides
    [limited.qMin[x], limited.qMax[x]] = [-1, 2];
    const { value, diagnostics } = readPoseJson('p.json', '{"joints":{"Root":[3.5,9,0]}}', limited);
    expect([...value!.q.slice(x, x + 3)]).toEqual([2, 9, 0]);
    expect(shown(diagnostics)).toEqual([
      'warning: p.json:1:20 (joints.Root[0]): expected x of "Root" from -1 to 2, found "3.5" [pose/range]; 2 is used',
    ]);
  });

  it('reports values for axes that a joint does not have', () => {
    const rig = characterOfRig(rotatedTree()).skeleton;
    // Joint 7 has only a hinge about z, joint 6 has none.
    const text = '{"joints":{"#7":[1,0,2],"#6":[0,0,3]}}';
    const { value, diagnostics } = readPoseJson('p.json', text, rig);
    const missing = (place: string, axis: string, joint: number, found: number): string =>
      `warning: p.json:1:${place}: expected no ${axis} for "joint ${joint}", which does not turn about it, ` +
      `found "${found}" [pose/ignored]; the value is left out`;
    expect(shown(diagnostics)).toEqual([
      missing('18 (joints."#7"[0])', 'x', 7, 1),
      missing('35 (joints."#6"[2])', 'z', 6, 3),
    ]);
    expect([...value!.q].filter((each, i) => each !== rig.qRest[i])).toEqual([2]);
    const none = readPoseJson('p.json', '{"root":[0,1,0]}', emptySkeleton);
    expect(shown(none.diagnostics)).toEqual([
      'warning: p.json:1:12 (root[1]): expected no y for the root, which does not move along it, found "1" ' +
        '[pose/ignored]; the value is left out',
    ]);
  });

  it('refuses what is not JSON', () => {
    expect(messages('{"joints":')[0]).toBe(
      'error: p.json:1:11 (joints): expected a value, found "the end of the text" [pose/json]; the pose is not used',
    );
    expect(messages('')[0]).toContain('[pose/json]');
  });

  it('refuses a name that two joints have', () => {
    const twins = {
      ...skeleton,
      names: skeleton.names.map((name) => name.replace(/Left|Right/, 'A')),
    };
    expect(messages('{"joints":{"A hip":[0,0,0]}}', twins)).toEqual([
      'error: p.json:1:12 (joints."A hip"): expected a name that only one joint has, found "A hip" ' +
        '[pose/unknown-joint]; the pose is not used',
    ]);
  });

  it('gives a pose or reports why not, for any text and any value', () => {
    fc.assert(
      fc.property(fc.oneof(fc.string(), fc.json()), (text) => {
        const { value, diagnostics } = readPoseJson('p.json', text, skeleton);
        expect(value === undefined).toBe(hasErrors(diagnostics));
      }),
    );
    const unlike = [undefined, () => 0, 1n, Symbol('x'), { root: 1n }, { joints: { Neck: [1n] } }];
    for (const value of unlike) {
      expect(shown(poseFromJson('p.json', value, skeleton).diagnostics)).toHaveLength(1);
    }
  });
});

describe('ball joints', async () => {
  const balls = (await readOne({ 'a.pmd': squarePmd })).skeleton;
  const ofChild = (json: unknown): number[] => q({ joints: { '#1': json } }, balls).slice(7, 11);
  const [half, cosine] = [Math.sin(0.25), Math.cos(0.25)];

  it('take a quaternion, which is normalized', () => {
    expect(ofChild([0, half, 0, cosine])).toEqual([0, half, 0, cosine]);
    expect(ofChild([0, 0, -3, 4])).toEqual([0, 0, -0.6, 0.8]);
    expect(ofChild([1e-300, 0, 0, 0])).toEqual([1, 0, 0, 0]);
  });

  it.each(['x', 'y', 'z'] as const)('take three angles: %s alone', (axis) => {
    const index = 'xyz'.indexOf(axis);
    const wanted = [0, 0, 0, cosine].with(index, half);
    expect(largestDifference(ofChild([0, 0, 0].with(index, 0.5)), wanted)).toBeLessThan(1e-15);
  });

  it('turn by three angles as the hinges of 6.837 do, by Rx · Ry · Rz', () => {
    const angles = [0.4, -1.1, 2.5];
    const byBall = q({ joints: { '#0': angles } }, balls);
    const byHinges = q({ joints: { '#0': angles } });
    const turn = (of: Skeleton, values: number[]) =>
      jointMatrices(of, Float64Array.from(values)).slice(0, 12);
    const difference = largestDifference(turn(balls, byBall), turn(skeleton, byHinges));
    expect(difference).toBeLessThan(1e-15);
  });

  it.each([
    [
      '[0,0,0,0]',
      ':1:17 (joints."#1")',
      'a quaternion with a length for "#1", found "[0,0,0,0]" [pose/range]',
    ],
    [
      '[1e19,0,0,0]',
      ':1:18 (joints."#1"[0])',
      'numbers within ±1e18 for "#1", found "[10000000000000000000,0,0,0]" [pose/range]',
    ],
    [
      '[1e19,0,0]',
      ':1:18 (joints."#1"[0])',
      'numbers within ±1e18 for "#1", found "[10000000000000000000,0,0]" [pose/range]',
    ],
    ['[1,2]', ':1:17 (joints."#1")', 'three or four numbers for "#1", found "[1,2]" [pose/json]'],
    [
      '[0,0,0,"1"]',
      ':1:24 (joints."#1"[3])',
      'three or four numbers for "#1", found "[0,0,0,"1"]" [pose/json]',
    ],
  ])('refuse %s', (value, place, message) => {
    expect(messages(`{"joints":{"#1":${value}}}`, balls)).toEqual([
      `error: p.json${place}: expected ${message}; the pose is not used`,
    ]);
  });

  it('are the only joints that accept four numbers', () => {
    expect(messages('{"joints":{"Neck":[0,0,0,1]}}')[0]).toContain('three numbers for "Neck"');
  });

  it('are written as quaternions, where they are turned, and read again bit by bit', () => {
    const posed = q(
      { joints: { ﾈｸﾀｲ: [0.1, 0.2, 0.3], IK: [0, 0, 0, 1] }, root: [1, 2, 3] },
      balls,
    );
    const json = poseToJson(balls, { q: Float64Array.from(posed) });
    expect(Object.entries(json.joints!).map(([name, values]) => [name, values.length])).toEqual([
      ['ﾈｸﾀｲ', 4],
    ]);
    expect(json.root).toEqual([1, 2, 3]);
    expect(q(json, balls)).toEqual(posed);
    const number = fc.double({ min: -1, max: 1, noNaN: true });
    fc.assert(
      fc.property(fc.tuple(number, number, number, number), (values) => {
        fc.pre(Math.hypot(...values) > 1e-9);
        const first = q({ joints: { IK: values } }, balls);
        const text = poseToJson(balls, { q: Float64Array.from(first) });
        // JSON has no −0.
        expect(q(text, balls).map((each) => each + 0)).toEqual(first.map((each) => each + 0));
      }),
    );
  });

  it('of other trees keep their positions, because "root" moves only the first root', () => {
    const moved = q({ root: [1, 2, 3] }, balls);
    const changed = moved.flatMap((value, i) => (value === balls.qRest[i] ? [] : [i]));
    expect(changed).toEqual([0, 1, 2]);
  });
});

describe('poseFromJson', () => {
  it('reports only the path, because a value has no line', () => {
    const { diagnostics } = poseFromJson('pose', { joints: { 'Left elbow': [0, 'x'] } }, skeleton);
    expect(diagnostics).toEqual([
      {
        severity: 'error',
        code: 'pose/json',
        file: 'pose',
        path: 'joints."Left elbow"',
        expected: 'three numbers for "Left elbow"',
        found: '[0,"x"]',
        effect: 'the pose is not used',
      },
    ]);
  });

  it('takes the version 1, and members that are undefined as absent', () => {
    const json = { version: 1, root: undefined, joints: undefined };
    expect(poseFromJson('pose', json, skeleton).diagnostics).toEqual([]);
  });
});

describe('poseToJson', () => {
  it('names only what differs from the pose of the file', () => {
    const { value } = poseFromJson('p.json', { joints: { Neck: [0, 1, 0] } }, skeleton);
    expect(poseToJson(skeleton, value!)).toEqual({ joints: { Neck: [0, 1, 0] } });
    const moved = poseFromJson('p.json', { root: [0, 0, 2] }, skeleton).value!;
    expect(poseToJson(skeleton, moved)).toEqual({ joints: {}, root: [0, 0, 2] });
  });

  it('is read again as the same pose, bit by bit', () => {
    const angle = fc.double({ min: -1e6, max: 1e6, noNaN: true });
    const triple = fc.tuple(angle, angle, angle);
    const joints = fc.dictionary(fc.constantFrom(...skeleton.names), triple);
    const poses = fc.record({ joints, root: triple }, { requiredKeys: [] });
    fc.assert(
      fc.property(poses, (json) => {
        const pose = poseFromJson('p.json', json, skeleton).value!;
        const text = JSON.stringify(poseToJson(skeleton, pose));
        // JSON has no −0; adding 0 makes it 0.
        const again = readPoseJson('p.json', text, skeleton).value!.q.map((value) => value + 0);
        expect(again).toEqual(pose.q.map((value) => value + 0));
      }),
    );
  });
});
