import { type ReadonlyVec3, vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { emptyBounds, includePositions } from '../../src/core/bounds.ts';
import type { Camera } from '../../src/document/camera.ts';
import { axesOf, clipFromScene, eyeOf, frameBox, zoom } from '../../src/view/camera.ts';
import { fieldOfViewOf, focalLengthOf, orbit, pan } from '../../src/view/camera-moves.ts';
import { rayThrough, sizeOfPixel } from '../../src/view/picking.ts';
import { tolerances } from '../tolerances.ts';

const camera: Camera = {
  target: [0.1, 0.5, -0.2],
  distance: 2,
  azimuth: 0.4,
  elevation: 0.2,
  fieldOfView: 0.6,
  projection: 'perspective',
};

const projections = ['perspective', 'orthographic'] as const;
const kinds = fc.constantFrom(...projections);
const length = fc.double({ min: -3, max: 3, noNaN: true });
const cameras: fc.Arbitrary<Camera> = fc.record({
  target: fc.tuple(length, length, length),
  distance: fc.double({ min: 0.1, max: 9, noNaN: true }),
  azimuth: fc.double({ min: -9, max: 9, noNaN: true }),
  elevation: fc.double({ min: -Math.PI / 2, max: Math.PI / 2, noNaN: true }),
  fieldOfView: fc.double({ min: 0.2, max: 1.6, noNaN: true }),
  projection: kinds,
});
/** A place of a picture, from -1 to 1. */
const places = fc.tuple(
  fc.double({ min: -1, max: 1, noNaN: true }),
  fc.double({ min: -1, max: 1, noNaN: true }),
);

/** The position of a point of the scene in the picture, from -1 to 1. */
function project(from: Camera, point: ReadonlyVec3, aspect: number): vec3 {
  return vec3.transformMat4(new Float64Array(3), point, clipFromScene(from, aspect));
}

describe('the camera', () => {
  it('looks from +z at azimuth 0, and from +x at a quarter turn', () => {
    const level = { ...camera, target: [0, 0, 0], elevation: 0 } as const;
    expect([...eyeOf({ ...level, azimuth: 0 })].map((x) => Math.round(x * 1e9))).toEqual([
      0, 0, 2e9,
    ]);
    const quarter = eyeOf({ ...level, azimuth: Math.PI / 2 });
    expect([...quarter].map((x) => Math.round(x * 1e9))).toEqual([2e9, 0, 0]);
  });

  it('keeps its target in the middle while it orbits and zooms', () => {
    fc.assert(
      fc.property(fc.double({ min: -9, max: 9, noNaN: true }), (turn) => {
        const moved = zoom(orbit(camera, turn, turn / 3), 1.3);
        const [x, y] = project(moved, moved.target, 1.5);
        expect(Math.hypot(x!, y!)).toBeLessThan(1e-9);
      }),
    );
  });

  it('never turns over the pole', () => {
    expect(orbit(camera, 0, 100).elevation).toBeLessThan(Math.PI / 2);
    expect(orbit(camera, 0, -100).elevation).toBeGreaterThan(-Math.PI / 2);
  });

  it.each(projections)('pans so that the picture follows the hand: %s', (projection) => {
    const from = { ...camera, projection };
    const moved = pan(from, 0.25, 0.1); // a quarter of the height to the right, a tenth up
    const [x, y] = project(moved, from.target, 1);
    expect(x).toBeCloseTo(-0.5, 6);
    expect(y).toBeCloseTo(-0.2, 6);
  });

  it('looks straight down with the character facing the lower edge', () => {
    const above = { ...camera, azimuth: 0, elevation: Math.PI / 2 };
    const [x, y, z] = above.target;
    const inFront = project(above, [x, y, z + 0.1], 1);
    const toItsLeft = project(above, [x + 0.1, y, z], 1);
    expect([inFront[0], inFront[1] < 0].map(Number)).toEqual([expect.closeTo(0, 9), 1]);
    expect([toItsLeft[0] > 0, toItsLeft[1]].map(Number)).toEqual([1, expect.closeTo(0, 9)]);
  });

  it('fits every box within the picture, up to its margin', () => {
    const corner = fc.tuple(length, length, length);
    const aspects = fc.double({ min: 0.4, max: 2.5, noNaN: true });
    fc.assert(
      fc.property(corner, corner, aspects, length, kinds, (a, b, aspect, azimuth, projection) => {
        const box = emptyBounds();
        includePositions(box, a, 1);
        includePositions(box, b, 1);
        const framed = frameBox({ ...camera, azimuth, projection }, box, aspect);
        let reach = 0;
        for (let i = 0; i < 8; i++) {
          const point = [0, 1, 2].map((axis) => (i & (1 << axis) ? box.max : box.min)[axis]!);
          const [x, y] = project(framed, point, aspect);
          reach = Math.max(reach, Math.abs(x!), Math.abs(y!));
        }
        expect(reach).toBeLessThanOrEqual(1 / 1.1 + 1e-6);
        if (framed.distance > 0.03 && framed.distance < 40) expect(reach).toBeGreaterThan(0.85);
      }),
    );
  });

  it('shows the plane through its target in the same size in both projections', () => {
    fc.assert(
      fc.property(cameras, places, (from, [x, y]) => {
        const point = onTargetPlane(from, x, y);
        for (const projection of projections) {
          const [seenX, seenY] = project({ ...from, projection }, point, 1.5);
          expect(seenX).toBeCloseTo(x, 6);
          expect(seenY).toBeCloseTo(y, 6);
        }
      }),
    );
  });

  it('without perspective shows everything in the same size, near and far alike', () => {
    fc.assert(
      fc.property(cameras, places, length, (from, [x, y], depth) => {
        const flat = { ...from, projection: 'orthographic' } as const;
        const { look } = axesOf(flat);
        const point = vec3.scaleAndAdd([0, 0, 0], onTargetPlane(flat, x, y), look, depth * 10);
        const [seenX, seenY, seenZ] = project(flat, point, 1.5);
        expect(seenX).toBeCloseTo(x, 6);
        expect(seenY).toBeCloseTo(y, 6);
        expect(Math.abs(seenZ!)).toBeLessThan(1);
      }),
    );
  });
});

describe('a ray of a view', () => {
  it('is the inverse of the projection: all of its points are at its place', () => {
    fc.assert(
      fc.property(cameras, places, length, (from, [x, y], beyond) => {
        const { origin, direction } = rayThrough(from, 1.5, x, y);
        expect(vec3.length(direction)).toBeCloseTo(1, 9);
        const reach = vec3.distance(origin, from.target);
        const ahead = reach + (beyond * from.distance) / 4;
        const point = vec3.scaleAndAdd(new Float64Array(3), origin, direction, ahead);
        const [seenX, seenY] = project(from, point, 1.5);
        expect(seenX).toBeCloseTo(x, 6);
        expect(seenY).toBeCloseTo(y, 6);
      }),
    );
  });

  it('has a neighbor one pixel on, at the distance that the size of a pixel says', () => {
    fc.assert(
      fc.property(cameras, (from) => {
        const height = 800;
        const rays = [0, 2 / height].map((y) => rayThrough(from, 1, 0, y));
        const reach = vec3.distance(eyeOf(from), from.target);
        const [a, b] = rays.map(({ origin, direction }) =>
          vec3.scaleAndAdd(new Float64Array(3), origin, direction, reach),
        );
        const pixel = sizeOfPixel(from, height) * reach;
        expect(vec3.distance(a!, b!) / pixel).toBeCloseTo(1, 4);
      }),
    );
  });
});

describe('the focal length', () => {
  it('is that of a 35 mm camera', () => {
    // 24 mm of film at 50 mm see 2 atan(12 / 50) = 27°.
    expect((fieldOfViewOf(50) * 180) / Math.PI).toBeCloseTo(26.99, 2);
    expect(focalLengthOf(Math.PI / 2)).toBeCloseTo(12, 12);
  });

  it('and the field of view are two words for the same', () => {
    fc.assert(
      fc.property(fc.double({ min: 5, max: 400, noNaN: true }), (focalLength) => {
        const back = focalLengthOf(fieldOfViewOf(focalLength));
        expect(Math.abs(back - focalLength)).toBeLessThan(tolerances.turn * focalLength);
      }),
    );
  });
});

/** A point of the plane through the target, by its place in a picture of aspect 1.5. */
function onTargetPlane(from: Camera, x: number, y: number): vec3 {
  const { right, up } = axesOf(from);
  const height = from.distance * Math.tan(from.fieldOfView / 2);
  const point = vec3.scaleAndAdd(new Float64Array(3), from.target, right, x * height * 1.5);
  return vec3.scaleAndAdd(point, point, up, y * height);
}
