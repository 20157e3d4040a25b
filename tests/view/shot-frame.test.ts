import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { startCamera } from '../../src/document/camera.ts';
import { aspects } from '../../src/document/shots.ts';
import { clipFromScene } from '../../src/view/camera.ts';
import { cameraBetween } from '../../src/view/camera-path.ts';
import { frameWithin, widened } from '../../src/view/shot-frame.ts';

const viewAspects = fc.double({ min: 0.3, max: 4, noNaN: true });
const ratios = fc.constantFrom(...aspects.flatMap(({ ratio }) => ratio ?? []));
const number = fc.double({ min: -1, max: 1, noNaN: true });
const kinds = fc.constantFrom('perspective', 'orthographic');

it('the frame has its ratio, is inside the view, and touches the room beside it', () => {
  fc.assert(
    fc.property(viewAspects, ratios, (aspect, ratio) => {
      const { width, height } = frameWithin(aspect, ratio);
      expect((width * aspect) / height / ratio).toBeCloseTo(1, 9);
      const beside = [(1 - width) * aspect, 1 - height].map((room) => room / Math.min(1, aspect));
      expect(Math.min(...beside)).toBeCloseTo(0.08, 9);
    }),
  );
  expect(frameWithin(1.5, null)).toEqual({ width: 1, height: 1 });
});

it('a shot shows the same in its frame, whatever the size of the window', () => {
  const points = fc.tuple(number, number, number);
  fc.assert(
    fc.property(viewAspects, ratios, kinds, points, (aspect, ratio, projection, point) => {
      const camera = { ...startCamera, azimuth: 0.4, projection } as const;
      const { width, height } = frameWithin(aspect, ratio);
      const inView = place(widened(camera, 1 / height), aspect, point);
      const inPicture = place(camera, ratio, point);
      expect(inView[0] / width).toBeCloseTo(inPicture[0], 6);
      expect(inView[1] / height).toBeCloseTo(inPicture[1], 6);
    }),
  );
});

it('the way to another camera begins and ends at it, and takes the shorter turn', () => {
  const [from, to] = [
    { ...startCamera, azimuth: 3 },
    { ...startCamera, azimuth: -3, distance: 10, fieldOfView: 1 },
  ];
  expect(cameraBetween(from, to, 1)).toBe(to);
  expect(cameraBetween(from, to, 0)).toEqual(from);
  const half = cameraBetween(from, to, 0.5);
  expect(Math.cos(half.azimuth)).toBeCloseTo(-1, 9);
  expect(half.distance).toBeCloseTo(5, 9);
});

function place(camera: typeof startCamera, aspect: number, point: vec3): vec3 {
  return vec3.transformMat4(new Float64Array(3), point, clipFromScene(camera, aspect));
}
