import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Camera } from '../../src/document/camera.ts';
import { axesOf, clipFromScene, eyeOf } from '../../src/view/camera.ts';
import {
  type FirstPerson,
  firstPersonFrom,
  lookAround,
  orbitFrom,
  walk,
} from '../../src/view/first-person.ts';

const angle = fc.double({ min: -9, max: 9, noNaN: true });
const length = fc.double({ min: -3, max: 3, noNaN: true });
const cameras: fc.Arbitrary<Camera> = fc.record({
  target: fc.tuple(length, length, length),
  distance: fc.double({ min: 0.1, max: 9, noNaN: true }),
  azimuth: angle,
  elevation: fc.double({ min: -1.5, max: 1.5, noNaN: true }),
  fieldOfView: fc.constant(0.6),
  projection: fc.constant('perspective'),
});

const level: FirstPerson = { eye: [1, 2, 3], yaw: 0, pitch: 0, fieldOfView: 0.6, distance: 2 };

function expectClose(found: ArrayLike<number>, expected: readonly number[]): void {
  expected.forEach((value, i) => expect(found[i]).toBeCloseTo(value, 9));
}

describe('the axes of a view', () => {
  it('are those of its matrix: right, up, and from the eye to the center', () => {
    fc.assert(
      fc.property(cameras, (camera) => {
        const { right, up, look } = axesOf(camera);
        const show = (axis: readonly number[] | vec3) => {
          const point = vec3.scaleAndAdd(new Float64Array(3), camera.target, axis, 0.01);
          return vec3.transformMat4(new Float64Array(3), point, clipFromScene(camera, 1));
        };
        const [toRight, toTop, ahead] = [right, up, look].map((axis) => show(axis as vec3));
        expect(toRight![0]).toBeGreaterThan(0);
        expect(Math.abs(toRight![1])).toBeLessThan(1e-9);
        expect(toTop![1]).toBeGreaterThan(0);
        expect(Math.abs(toTop![0])).toBeLessThan(1e-9);
        expect(Math.hypot(ahead![0], ahead![1])).toBeLessThan(1e-9);
        expect(vec3.dot(vec3.cross(new Float64Array(3), right, up), look)).toBeCloseTo(-1, 9);
      }),
    );
  });
});

describe('the first-person camera', () => {
  it('sees what the orbit camera saw, and converts back to it', () => {
    fc.assert(
      fc.property(cameras, (camera) => {
        const back = orbitFrom(firstPersonFrom(camera));
        expectClose(back.target, camera.target);
        expect(back).toEqual({ ...camera, target: back.target });
      }),
    );
  });

  it('keeps its eye while it looks around, to the left and up', () => {
    fc.assert(
      fc.property(cameras, angle, angle, (camera, left, up) => {
        const before = firstPersonFrom(camera);
        expectClose(eyeOf(orbitFrom(lookAround(before, left, up))), [...before.eye]);
      }),
    );
    const { look } = axesOf(orbitFrom(lookAround(level, 0.1, 0.2)));
    expect(look[0]).toBeLessThan(0);
    expect(look[1]).toBeGreaterThan(0);
  });

  it('never turns over the pole', () => {
    expect(lookAround(level, 0, 100).pitch).toBeLessThan(Math.PI / 2);
    expect(lookAround(level, 0, -100).pitch).toBeGreaterThan(-Math.PI / 2);
  });

  it('walks forward, sideways and up', () => {
    expectClose(walk(level, 2, 0, 0).eye, [1, 2, 1]);
    expectClose(walk(level, 0, 0.5, 0).eye, [1.5, 2, 3]);
    expectClose(walk(level, 0, 0, 1).eye, [1, 3, 3]);
    expectClose(walk({ ...level, yaw: Math.PI / 2 }, 2, 0, 0).eye, [-1, 2, 3]);
    expectClose(walk({ ...level, pitch: Math.PI / 6 }, 2, 0, 0).eye, [1, 3, 3 - Math.sqrt(3)]);
  });
});
