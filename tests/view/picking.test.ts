import { vec3 } from 'gl-matrix';
import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import { jointMatrices } from '../../src/core/forward-kinematics.ts';
import { pointOnRay } from '../../src/core/ray.ts';
import type { Camera } from '../../src/document/camera.ts';
import { clipFromScene } from '../../src/view/camera.ts';
import { displayTransform } from '../../src/evaluation/display-transform.ts';
import {
  characterRay,
  pickBone,
  pickJoint,
  rayThrough,
  sizeOfPixel,
} from '../../src/view/picking.ts';
import { readOne } from '../support/files.ts';

const camera: Camera = {
  target: [0, 0.5, 0],
  distance: 2.5,
  azimuth: 0.3,
  elevation: 0.2,
  fieldOfView: 0.6,
  projection: 'perspective',
};
const viewHeight = 800;
const aspect = 1.25;

/** Three bones in a row along y, of 20 units in all, which is the course's scale. */
const chain = '0 0 0 -1\n0 8 0 0\n0 8 0 1\n0 4 0 2\n';

async function targetOf(text: string) {
  const character: Character = await readOne({ 'a.skel': text });
  const { skeleton } = character;
  const characterFromJoint = jointMatrices(skeleton, skeleton.qRest);
  return { character, display: displayTransform(character), characterFromJoint };
}

/** The offset of a character's point from the middle of the view, in pixels to the right and up. */
function pixelsOf(
  { display }: Awaited<ReturnType<typeof targetOf>>,
  point: vec3,
): [number, number] {
  const place = vec3.transformMat4(new Float64Array(3), point, display.sceneFromCharacter);
  vec3.transformMat4(place, place, clipFromScene(camera, aspect));
  return [(place[0] * viewHeight * aspect) / 2, (place[1] * viewHeight) / 2];
}

function rayAtPixel(x: number, y: number) {
  return rayThrough(camera, aspect, x / ((viewHeight * aspect) / 2), y / (viewHeight / 2));
}

const mouse = 6 * sizeOfPixel(camera, viewHeight);
const finger = 20 * sizeOfPixel(camera, viewHeight);

describe('picking bones', () => {
  it('reports which bone was hit, where along it, and at what distance', async () => {
    const target = await targetOf(chain);
    const ray = rayAtPixel(...pixelsOf(target, [0, 11, 0]));
    const hit = pickJoint(target, ray, 0)!;
    expect(hit.joint).toBe(1);
    expect(hit.bone?.child).toBe(2);
    // The point is on the cylinder of radius 0.25, near the height of the bone's middle.
    expect(Math.hypot(hit.point[0], hit.point[2])).toBeCloseTo(0.25, 6);
    expect(hit.point[1]).toBeCloseTo(3, 0);
    const place = pointOnRay(characterRay(target.display, ray), hit.distance);
    [hit.point[0], hit.point[1] + 8, hit.point[2]].forEach((value, i) =>
      expect(place[i]).toBeCloseTo(value, 9),
    );
  });

  it.each([
    ['a mouse', mouse, 6],
    ['a finger', finger, 20],
  ])('is near enough for %s within its pixels', async (_, tolerance, pixels) => {
    const target = await targetOf('0 0 0 -1\n0 4000 0 0\n4000 0 0 1\n');
    // At this distance the radius is less than a pixel.
    const distant = { ...camera, distance: 300 };
    const middle = (point: vec3, aside: number) => {
      const place = vec3.transformMat4(
        new Float64Array(3),
        point,
        target.display.sceneFromCharacter,
      );
      vec3.transformMat4(place, place, clipFromScene(distant, aspect));
      const x = place[0] + (2 * aside) / (viewHeight * aspect);
      return pickBone(target, rayThrough(distant, aspect, x, place[1]), tolerance);
    };
    expect(middle([0, 2000, 0], -(pixels - 0.5))?.joint).toBe(0);
    expect(middle([0, 2000, 0], -(pixels + 0.5))).toBeNull();
  });

  it('prefers a bone that is hit to one that is only near', async () => {
    // The second bone is four units behind the first, a little to its side.
    const target = await targetOf('0 0 0 -1\n0 20 0 0\n0.6 0 -1 -1\n0 20 0 2\n');
    const [x, y] = pixelsOf(target, [0.6, 10, -1]);
    expect(pickBone(target, rayAtPixel(x, y), finger)?.joint).toBe(2);
  });

  it('takes the nearest of the bones that are hit', async () => {
    const target = await targetOf('0 0 -5 -1\n0 20 0 0\n0 0 5 -1\n0 20 0 2\n');
    const ray = rayAtPixel(...pixelsOf(target, [0, 10, 5]));
    expect(pickBone(target, ray, 0)?.joint).toBe(2);
  });

  it('hits the spheres of joints, except if only bones are picked', async () => {
    const target = await targetOf(chain);
    const [x, y] = pixelsOf(target, [0, 8, 0]);
    const ray = rayAtPixel(x + 12, y);
    expect(pickJoint(target, ray, 0)).toMatchObject({ joint: 1, bone: null });
    expect(pickBone(target, ray, 0)).toBeNull();
  });
});
