import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { emptyBounds, includePositions } from '../../src/core/bounds.ts';
import { type Camera, clipFromScene, eyeOf, frameBox, zoom } from '../../src/view/camera.ts';
import { orbit, pan } from '../../src/view/camera-moves.ts';

const camera: Camera = {
  target: [0.1, 0.5, -0.2],
  distance: 2,
  azimuth: 0.4,
  elevation: 0.2,
  fieldOfView: 0.6,
};

/** The position of a point of the scene in the picture, from -1 to 1. */
function project(from: Camera, point: readonly number[], aspect: number): vec3 {
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

  it('pans so that the picture follows the hand', () => {
    const moved = pan(camera, 0.25, 0.1); // a quarter of the height to the right, a tenth up
    const [x, y] = project(moved, camera.target, 1);
    expect(x).toBeCloseTo(-0.5, 6);
    expect(y).toBeCloseTo(-0.2, 6);
  });

  it('fits every box within the picture, up to its margin', () => {
    const number = fc.double({ min: -3, max: 3, noNaN: true });
    const corner = fc.tuple(number, number, number);
    const aspects = fc.double({ min: 0.4, max: 2.5, noNaN: true });
    fc.assert(
      fc.property(corner, corner, aspects, number, (a, b, aspect, azimuth) => {
        const box = emptyBounds();
        includePositions(box, a, 1);
        includePositions(box, b, 1);
        const framed = frameBox({ ...camera, azimuth }, box, aspect);
        let reach = 0;
        for (let i = 0; i < 8; i++) {
          const point = [0, 1, 2].map((axis) => (i & (1 << axis) ? box.max : box.min)[axis]!);
          const [x, y] = project(framed, point, aspect);
          reach = Math.max(reach, Math.abs(x!), Math.abs(y!));
        }
        expect(reach).toBeLessThanOrEqual(1 / 1.1 + 1e-6);
        if (framed.distance > 0.03) expect(reach).toBeGreaterThan(0.85);
      }),
    );
  });
});
