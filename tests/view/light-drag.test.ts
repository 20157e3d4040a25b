import fc from 'fast-check';
import { expect, it } from 'vitest';
import { startCamera } from '../../src/document/camera.ts';
import { studio } from '../../src/document/environment.ts';
import { isInFront, lightAnglesAt } from '../../src/view/light-drag.ts';
import { lightHandles } from '../../src/view/light-handles.ts';
import { pixelsIn } from '../../src/view/overlay.ts';

const camera = fc.record({
  azimuth: fc.double({ min: -3, max: 3, noNaN: true }),
  elevation: fc.double({ min: -1.4, max: 1.4, noNaN: true }),
  distance: fc.double({ min: 0.5, max: 9, noNaN: true }),
  projection: fc.constantFrom('perspective' as const, 'orthographic' as const),
});
const view = fc.record({ camera, width: fc.integer({ min: 300, max: 900 }) }).map((made) => ({
  camera: { ...startCamera, ...made.camera, target: [0.2, 0.5, -0.1] as const },
  width: made.width,
  height: 600,
}));
const angles = fc.record({
  azimuth: fc.double({ min: -179, max: 179, noNaN: true }),
  elevation: fc.double({ min: -85, max: 85, noNaN: true }),
});

it('a light that is dropped where its disc is stays where it is', () => {
  fc.assert(
    fc.property(view, angles, (view, angles) => {
      const lights = [{ ...studio.lights[0]!, ...angles }];
      const [handle] = lightHandles({ ...studio, lights }, view);
      const place = pixelsIn(view)(handle!.place);
      const found = [true, false].map((front) => lightAnglesAt(view, place, front));
      const gaps = found.map((each) => distanceBetween(each, angles));
      // At the outline a small change of place is a large one of depth.
      expect(Math.min(...gaps)).toBeLessThan(1e-4);
      // The eye sees less than half of a sphere, so that the halves differ a little from its own.
      const facing = isInFront(angles, view);
      if (Math.abs(gaps[0]! - gaps[1]!) > 1) expect(gaps[0]! < gaps[1]!).toBe(facing);
    }),
  );
});

it('beyond the outline, the light goes on behind the characters', () => {
  const seen = { camera: startCamera, width: 600, height: 600 };
  const depths = [0, 100, 200, 230, 260, 300, 420].map((x) => {
    const [, , z] = directionOf(lightAnglesAt(seen, [x, 0], true));
    return z;
  });
  expect([...depths].sort((a, b) => b - a)).toEqual(depths);
  expect(depths[0]).toBeCloseTo(1, 6);
  expect(depths.at(-1)).toBeLessThan(-0.9);
  expect(isInFront({ azimuth: 0, elevation: 10 }, seen)).toBe(true);
  expect(isInFront({ azimuth: 180, elevation: 10 }, seen)).toBe(false);
});

type Triple = [number, number, number];

function directionOf({ azimuth, elevation }: { azimuth: number; elevation: number }): Triple {
  const [around, above] = [azimuth, elevation].map((angle) => (angle * Math.PI) / 180) as [
    number,
    number,
  ];
  return [Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above)];
}

function distanceBetween(
  a: { azimuth: number; elevation: number },
  b: { azimuth: number; elevation: number },
): number {
  const [from, to] = [directionOf(a), directionOf(b)];
  return Math.hypot(...from.map((each, i) => each - to[i]!));
}
