import { vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { displayTransform } from '../../src/evaluation/display-transform.ts';
import { pickBox } from '../../src/view/pick-box.ts';
import { characterRay } from '../../src/view/picking.ts';
import { poseFromJson } from '../../src/formats/pose-json.ts';
import { readOne } from '../support/files.ts';
import { randomSource } from '../support/random.ts';

/** An arm whose boxes are rotated and do not overlap. */
const arm = `balljoint shoulder {
  boxmin -0.2 -0.1 -0.3  boxmax 0.9 0.1 0.3
  balljoint elbow { offset 1 0 0  boxmin 0.1 -0.2 -0.1  boxmax 1 0.2 0.1 }
}`;

async function openArm() {
  const character = await readOne({ 'arm.skel': arm });
  const json = { joints: { shoulder: [0.4, -0.3, 0.6], elbow: [0.2, 0.5, -0.9] } };
  const { q } = poseFromJson('pose', json, character.skeleton).value!;
  const display = displayTransform(character);
  return { character, display, characterFromJoint: jointMatrices(character.skeleton, q) };
}

type Target = Awaited<ReturnType<typeof openArm>>;

/** Returns the joint whose box contains a point of the scene, by a simple test of every box. */
function boxAround({ character, display, characterFromJoint }: Target, point: vec3): number | null {
  const boxes = character.skeleton.displayBoxes!;
  const scene = (joint: number, at: vec3): vec3 => {
    const world = characterFromJoint.subarray(joint * 16, joint * 16 + 16);
    const posed = vec3.transformMat4(vec3.create(), at, world);
    return vec3.transformMat4(posed, posed, display.sceneFromCharacter);
  };
  for (let joint = 0; joint < character.skeleton.jointCount; joint++) {
    const box = boxes.subarray(joint * 6, joint * 6 + 6);
    const low = scene(joint, [box[0]!, box[1]!, box[2]!]);
    const inside = [0, 1, 2].every((axis) => {
      const corner: vec3 = [box[0]!, box[1]!, box[2]!];
      corner[axis] = box[axis + 3]!;
      const edge = vec3.subtract(vec3.create(), scene(joint, corner), low);
      const along = vec3.dot(vec3.subtract(vec3.create(), point, low), edge);
      return along >= 0 && along <= vec3.dot(edge, edge);
    });
    if (inside) return joint;
  }
  return null;
}

describe('picking boxes', () => {
  it('finds the box that a walk along the ray enters first', async () => {
    const target = await openArm();
    const random = randomSource(169);
    const around = (size: number): vec3 => [
      (random() - 0.5) * size,
      (random() - 0.5) * size + 0.5,
      (random() - 0.5) * size,
    ];
    const found = new Set<number | null>();
    for (let round = 0; round < 150; round++) {
      const origin = around(8);
      const direction = vec3.normalize(
        vec3.create(),
        vec3.subtract(vec3.create(), around(1.5), origin),
      );
      let expected: number | null = null;
      for (let at = 0; at < 8 && expected === null; at += 0.004) {
        expected = boxAround(target, vec3.scaleAndAdd(vec3.create(), origin, direction, at));
      }
      const picked = pickBox(target, characterRay(target.display, { origin, direction }));
      // A walk may step over the edge of a box that the ray only grazes.
      if (expected !== null) expect(picked?.joint).toBe(expected);
      found.add(expected);
    }
    expect(found).toEqual(new Set([null, 0, 1]));
  });

  it('misses what is behind the ray, and everything if there are no boxes', async () => {
    const target = await openArm();
    expect(pickBox(target, { origin: [0, 0.5, -9], direction: [0, 0, -1] })).toBeNull();
    const plain = await readOne({ 'a.skel': '0 0 0 -1\n0 1 0 0\n' });
    expect(
      pickBox({ ...target, character: plain }, { origin: [0, 0.5, 9], direction: [0, 0, -1] }),
    ).toBeNull();
  });
});
