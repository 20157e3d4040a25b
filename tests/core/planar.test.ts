import { mat4, vec4 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  clippedBehind,
  type Plane,
  planarMirror,
  type PlanarLight,
  planarShadow,
} from '../../src/core/planar.ts';

type Four = [number, number, number, number];

const coordinate = fc.double({ min: -3, max: 3, noNaN: true });
const triple = fc.tuple(coordinate, coordinate, coordinate);
const plane = fc
  .tuple(triple, coordinate)
  .filter(([normal]) => Math.hypot(...normal) > 0.1)
  .map(([normal, d]): Plane => {
    const [x, y, z] = normal.map((each) => each / Math.hypot(...normal)) as [
      number,
      number,
      number,
    ];
    return [x, y, z, d];
  });
const light = fc
  .tuple(triple, fc.constantFrom(0, 1))
  .map(([place, w]): PlanarLight => [...place, w]);

const heightOver = ([x, y, z, d]: Plane, [px, py, pz, pw = 1]: readonly number[]): number =>
  x * px! + y * py! + z * pz! + d * pw;
const project = (matrix: mat4, point: readonly number[]): Four =>
  [...vec4.transformMat4(new Float64Array(4), [...point, 1] as Four, matrix)] as Four;

describe('a planar shadow', () => {
  it('lies on the plane, on the line from the light through the point', () => {
    fc.assert(
      fc.property(plane, light, triple, (plane, light, point) => {
        fc.pre(heightOver(plane, light) > 0.1);
        const [x, y, z, w] = project(planarShadow(plane, light), point);
        fc.pre(Math.abs(w) > 0.05);
        const shadow = [x / w, y / w, z / w];
        expect(heightOver(plane, shadow)).toBeCloseTo(0, 9);
        const toLight = light[3] === 0 ? light : light.map((each, i) => each - (point[i] ?? 0));
        const along = shadow.map((each, i) => each - point[i]!);
        const across = [0, 1, 2].map((i) => {
          const [j, k] = [(i + 1) % 3, (i + 2) % 3];
          return along[j]! * toLight[k]! - along[k]! * toLight[j]!;
        });
        expect(Math.hypot(...across)).toBeLessThan(1e-7 * (1 + Math.hypot(...along)) * 10);
      }),
    );
  });

  it('is real, by its w, if the light is before the plane and farther from it than the point', () => {
    fc.assert(
      fc.property(plane, light, triple, (plane, light, point) => {
        const [lightHeight, height] = [heightOver(plane, light), heightOver(plane, point)];
        const isReal = light[3] === 0 ? lightHeight > 0 : lightHeight > height;
        fc.pre(Math.abs(light[3] === 0 ? lightHeight : lightHeight - height) > 1e-9);
        expect(project(planarShadow(plane, light), point)[3] > 0).toBe(isReal);
      }),
    );
  });

  it('leaves the plane where it is', () => {
    fc.assert(
      fc.property(plane, light, triple, (plane, light, point) => {
        fc.pre(Math.abs(heightOver(plane, light)) > 0.1);
        const height = heightOver(plane, point);
        const foot = point.map((each, i) => each - height * plane[i]!);
        const [x, y, z, w] = project(planarShadow(plane, light), foot);
        [x, y, z].forEach((each, i) => expect(each / w).toBeCloseTo(foot[i]!, 8));
      }),
    );
  });
});

describe('a planar mirror', () => {
  it('keeps the foot of a point, turns its height around, and undoes itself', () => {
    fc.assert(
      fc.property(plane, triple, (plane, point) => {
        const mirror = planarMirror(plane);
        const image = project(mirror, point).slice(0, 3);
        const height = heightOver(plane, point);
        expect(heightOver(plane, image)).toBeCloseTo(-height, 9);
        image.forEach((each, i) => {
          expect(each).toBeCloseTo(point[i]! - 2 * height * plane[i]!, 9);
        });
        project(mirror, image).forEach((each, i) => expect(each).toBeCloseTo(point[i] ?? 1, 9));
      }),
    );
  });
});

describe('a projection that is clipped behind a plane', () => {
  const floor: Plane = [0, 1, 0, 0];
  const view = mat4.lookAt(new Float64Array(16), [0.7, -0.8, 2.4], [0, 0.4, 0], [0, 1, 0]);
  const projections = {
    'with perspective': mat4.perspective(new Float64Array(16), 0.6, 1.4, 0.05, 60),
    'without perspective': mat4.ortho(new Float64Array(16), -1.4, 1.4, -1, 1, 0.05, 60),
  };
  for (const [name, projection] of Object.entries(projections)) {
    const whole = mat4.multiply(new Float64Array(16), projection, view);
    const clipped = clippedBehind(whole, floor);
    it(`draws everything at the same place, and only what is before it, ${name}`, () => {
      const scattered = fc.tuple(...[5, 5, 5].map((size) => fc.double({ min: -size, max: size, noNaN: true }))); // prettier-ignore
      let [shown, hidden] = [0, 0];
      fc.assert(
        fc.property(scattered, (point) => {
          const [before, after] = [project(whole, point), project(clipped, point)];
          expect([after[0], after[1], after[3]]).toEqual([before[0], before[1], before[3]]);
          const isInside = ([x, y, z, w]: Four): boolean =>
            [x, y, z].every((each) => Math.abs(each) <= w);
          fc.pre(isInside(before) && Math.abs(point[1]!) > 1e-9);
          expect(isInside(after)).toBe(point[1]! > 0);
          if (point[1]! > 0) shown++;
          else hidden++;
        }),
        { numRuns: 300 },
      );
      expect(Math.min(shown, hidden)).toBeGreaterThan(10);
    });

    it(`keeps the order of depths along a line of sight, ${name}`, () => {
      const depths = [0.3, 0.6, 1, 1.5].map((height) => {
        // Points of one line of sight, higher and higher.
        const sceneFromClip = mat4.invert(new Float64Array(16), whole)!;
        const [nearEnd, farEnd] = [-1, 1].map((depth) => {
          const [x, y, z, w] = vec4.transformMat4(
            new Float64Array(4),
            [0.1, 0.4, depth, 1],
            sceneFromClip,
          ) as unknown as Four;
          return [x / w, y / w, z / w];
        });
        const part = (height - nearEnd![1]!) / (farEnd![1]! - nearEnd![1]!);
        const point = nearEnd!.map((each, i) => each + part * (farEnd![i]! - each));
        const [, , z, w] = project(clipped, point);
        return z / w;
      });
      expect([...depths].sort((a, b) => a - b)).toEqual(depths);
    });
  }
});
