import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { unmoved } from '../../src/document/scene.ts';
import { type Camera, startCamera } from '../../src/document/camera.ts';
import { pickOverlay, pixelsIn } from '../../src/view/overlay.ts';
import {
  axisOf,
  floorHandle,
  placeHandles,
  placeShapes,
  viewHandle,
} from '../../src/view/place-gizmo.ts';

const radius = 84;
const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const cameras: fc.Arbitrary<Camera> = fc.record({
  target: fc.tuple(number(-0.2, 0.2), number(0.3, 0.7), number(-0.2, 0.2)),
  distance: number(1.5, 30),
  azimuth: number(-3, 3),
  elevation: number(-1.4, 1.4),
  fieldOfView: number(0.3, 0.9),
  projection: fc.constantFrom('perspective', 'orthographic'),
});
const turned = { ...unmoved, rotation: [0, Math.sin(0.4), 0, Math.cos(0.4)] } as const;
const viewOf = (camera: Camera) => ({ camera, width: 1000, height: 800 });
const gizmo = { radius, hovered: null } as const;

describe('the handles of a whole character', () => {
  it('have one size in the picture, and are found where they are drawn', () => {
    fc.assert(
      fc.property(
        cameras,
        fc.constantFrom('move', 'turn', 'scale'),
        fc.constantFrom('world', 'local'),
        fc.nat(1e6),
        (camera, tool, axes, seed) => {
          const view = viewOf(camera);
          const shown = { ...gizmo, tool, axes };
          const handles = placeHandles({ transform: turned }, view, shown);
          const shapes = placeShapes(handles, shown);
          const pixels = pixelsIn(view);
          const [cx, cy] = pixels(turned.position);
          const far = shapes.flatMap(({ points }) =>
            points.map((point) => {
              const [x, y] = pixels(point);
              return Math.hypot(x - cx, y - cy);
            }),
          );
          // Toward the viewer an arrow is seen a little larger.
          expect(Math.max(...far)).toBeLessThan(radius * 1.6);
          expect(Math.max(...far)).toBeGreaterThan(radius * 0.8);
          const ids = new Set(handles.map(({ id }) => id));
          expect(new Set(shapes.map(({ id }) => id))).toEqual(ids);
          const shape = shapes[seed % shapes.length]!;
          const place = pixels(shape.points[seed % shape.points.length]!);
          expect(pickOverlay([shape], view, place, 1e-6)).toBe(shape.id);
          expect(ids).toContain(pickOverlay(shapes, view, place, 6));
          expect(pickOverlay(shapes, view, [cx + radius * 1.8, cy], 6)).toBeNull();
        },
      ),
      { numRuns: 150 },
    );
  });

  it('leave out what is seen end-on or edge-on, since it can not be dragged', () => {
    const handlesOf = (camera: Partial<Camera>) =>
      placeHandles(
        { transform: unmoved },
        viewOf({ ...startCamera, target: [0, 0, 0], ...camera }),
        {
          ...gizmo,
          tool: 'move',
          axes: 'world',
        },
      ).map(({ id }) => id);
    const [x, y, z] = [0, 1, 2].map((axis) => `place line ${axis}`);
    expect(handlesOf({ azimuth: 0.7, elevation: 0.5 })).toEqual([x, y, z, floorHandle, viewHandle]);
    expect(handlesOf({ elevation: 0 })).toEqual([x, y, viewHandle]);
    expect(handlesOf({ elevation: 1.55 })).toEqual([x, z, floorHandle, viewHandle]);
  });

  it('stand along the axes of the scene, or of the character', () => {
    expect(axisOf(turned, 'world', 2)).toEqual([0, 0, 1]);
    const [x, y, z] = axisOf(turned, 'local', 2);
    expect([x, y, z]).toEqual([
      expect.closeTo(Math.sin(0.8), 12),
      expect.closeTo(0, 12),
      expect.closeTo(Math.cos(0.8), 12),
    ]);
    expect(Math.hypot(x!, y!, z!)).toBeCloseTo(1, 12);
  });

  it('are filled where they are faces: inside is a hit, outside is not', () => {
    const view = viewOf({ ...startCamera, elevation: 0.6, azimuth: 0.6 });
    const shown = { ...gizmo, tool: 'move', axes: 'world' } as const;
    const faces = placeShapes(placeHandles({ transform: unmoved }, view, shown), shown).filter(
      (shape) => 'isFilled' in shape,
    );
    expect(faces.map(({ id }) => id)).toEqual([floorHandle]);
    const corners = faces[0]!.points.map(pixelsIn(view));
    const middle = [0, 1].map((i) => corners.reduce((sum, at) => sum + at[i]!, 0) / 4);
    const place = [middle[0]!, middle[1]!] as const;
    expect(pickOverlay(faces, view, place, 1e-6)).toBe(floorHandle);
    const beyond = [2 * corners[2]![0] - place[0], 2 * corners[2]![1] - place[1]] as const;
    expect(pickOverlay(faces, view, beyond, 1)).toBeNull();
  });
});
