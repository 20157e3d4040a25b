import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { openCharacter } from '../../src/document/open-characters.ts';
import { emptyScene, type Transform } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import type { Camera } from '../../src/document/camera.ts';
import { clipFromScene, startCamera } from '../../src/view/camera.ts';
import { type Gizmo, gizmoRings } from '../../src/view/gizmo.ts';
import { type OverlayView, pickOverlay } from '../../src/view/overlay.ts';
import { gizmoLines, gizmoSectors } from '../../src/view/ring-lines.ts';
import { readOne } from '../support/files.ts';

/** The middle joint has limits about x, none about y, and is locked about z. */
const skel = `balljoint root {
  offset 0 0 0
  balljoint middle {
    offset 0 4 0
    rotxlimit -0.5 1
    rotzlimit 0.2 0.2
    pose 0.3 -0.4 0.2
    balljoint end { offset 0 4 1 }
  }
}`;
const radius = 70;
const plain: Gizmo = { joint: 1, axes: 'local', radius, hovered: null, active: null };

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const cameras = fc.record({
  target: fc.tuple(number(-0.2, 0.2), number(0.3, 0.7), number(-0.2, 0.2)),
  distance: number(1.5, 12),
  azimuth: number(-3, 3),
  elevation: number(-1.4, 1.4),
  fieldOfView: number(0.3, 0.9),
  projection: fc.constantFrom('perspective', 'orthographic'),
});
const transforms = fc.record({
  position: fc.tuple(number(-0.1, 0.1), number(-0.1, 0.1), number(-0.1, 0.1)),
  rotation: fc.tuple(number(-1, 1), number(-1, 1), number(-1, 1)).map(([x, y, z]) => {
    const size = Math.hypot(x, y, z, 1);
    return [x / size, y / size, z / size, 1 / size] as const;
  }),
  scale: number(0.7, 1.3),
});

async function evaluationOf(transform: Transform) {
  const character = await readOne({ 'a.skel': skel });
  const scene = openCharacter(null, character, 'linear-blend').apply(emptyScene);
  return new Evaluator({ ...scene.actors[0]!, transform });
}

function viewOf(camera: Camera): OverlayView {
  return { camera, width: 1000, height: 800 };
}

/** Where the picture shows a point, computed from the matrix alone. */
function pixelsOf({ camera, width, height }: OverlayView, point: vec3): [number, number] {
  const m = clipFromScene(camera, width / height);
  const [x, y, w] = [0, 1, 3].map(
    (row) => m[row]! * point[0] + m[row + 4]! * point[1] + m[row + 8]! * point[2] + m[row + 12]!,
  );
  return [((x! / w!) * width) / 2, ((y! / w!) * height) / 2];
}

describe('the rings of a joint', () => {
  it('have one radius in the picture, wherever camera and character are', async () => {
    await fc.assert(
      fc.asyncProperty(cameras, transforms, async (camera, transform) => {
        const view = viewOf(camera);
        const rings = gizmoRings(await evaluationOf(transform), view, plain);
        expect(rings.map(({ ring }) => ring.axis)).toEqual([1, 0]);
        for (const { center, first, second } of rings) {
          const [cx, cy] = pixelsOf(view, center);
          let largest = 0;
          for (let turn = 0; turn < Math.PI; turn += 0.05) {
            const point = vec3.scaleAndAdd([0, 0, 0], center, first, Math.cos(turn));
            vec3.scaleAndAdd(point, point, second, Math.sin(turn));
            const [x, y] = pixelsOf(view, point);
            largest = Math.max(largest, Math.hypot(x - cx, y - cy));
          }
          // A near ring is seen larger at one side, and at the picture's edge it is stretched.
          expect(largest).toBeGreaterThan(radius * 0.95);
          expect(largest).toBeLessThan(radius * 1.26);
        }
      }),
      { numRuns: 60 },
    );
  });

  it('are found at their lines, and nowhere else', async () => {
    await fc.assert(
      fc.asyncProperty(cameras, transforms, fc.nat(1e6), async (camera, transform, seed) => {
        const view = viewOf(camera);
        const rings = gizmoRings(await evaluationOf(transform), view, plain);
        const lines = gizmoLines(rings, plain);
        const line = lines[seed % lines.length]!;
        const place = pixelsOf(view, line.points[seed % line.points.length] as vec3);
        expect(lines.map(({ id }) => id)).toContain(pickOverlay(lines, view, place, 6));
        expect(pickOverlay([line], view, place, 1e-6)).toBe(line.id);
        const [cx, cy] = pixelsOf(view, rings[0]!.center);
        expect(pickOverlay(lines, view, [cx + radius * 1.8, cy], 6)).toBeNull();
      }),
      { numRuns: 60 },
    );
  });

  it('are strong within their limits, faint beyond and behind the joint; the active one is on top', async () => {
    const turned = { azimuth: 0.3, elevation: 0.2 };
    const view = viewOf({ ...startCamera, ...turned, distance: 3 });
    const evaluation = await evaluationOf({
      position: [0, 0, 0],
      rotation: [0, 0, 0, 1],
      scale: 1,
    });
    const rings = gizmoRings(evaluation, view, plain);
    const eyeward = rings[0]!.toEye;
    const [y, x] = rings.map(({ id }) => id);
    // In front of the joint, there near to it in the picture, and behind it.
    const strong = [1, 0.55, 0.4];
    const lengthOf = (id: string, isStrong: boolean): number =>
      gizmoLines(rings, plain)
        .filter((line) => line.id === id && strong.includes(line.opacity) === isStrong)
        .flatMap(({ points }) => points.slice(1).map((p, i) => vec3.distance(p, points[i]!)))
        .reduce((sum, piece) => sum + piece, 0) / vec3.length(rings[0]!.first);
    // The mark of the present value adds its own length.
    const mark = lengthOf(y!, true) - 2 * Math.PI;
    expect(mark).toBeGreaterThan(0.1);
    expect(mark).toBeLessThan(0.5);
    expect(lengthOf(y!, false)).toBe(0);
    expect(lengthOf(x!, true) - mark).toBeCloseTo(1.5, 2);
    expect(lengthOf(x!, false)).toBeCloseTo(2 * Math.PI - 1.5, 2);
    for (const { points, opacity, id } of gizmoLines(rings, plain)) {
      const { center } = rings.find((ring) => ring.id === id)!;
      const away = points.map((point) => vec3.dot(vec3.sub([0, 0, 0], point, center), eyeward));
      if (opacity === 0.4) expect(Math.max(...away)).toBeLessThan(0.01);
      if (opacity === 1 || opacity === 0.55) expect(Math.min(...away)).toBeGreaterThan(-0.01);
    }
    const [sector, ...more] = gizmoSectors(rings, { ...plain, hovered: x! });
    expect([sector!.id, ...more.map(({ id }) => id)].every((id) => id === x)).toBe(true);
    expect(gizmoLines(rings, { ...plain, active: y! }).at(-1)!.id).toBe(y);
    expect(gizmoLines(rings, { ...plain, active: x! }).at(-1)!.id).toBe(x);
  });

  it('are about the axes of the scene and the line of sight, wherever the character stands', async () => {
    await fc.assert(
      fc.asyncProperty(cameras, transforms, async (camera, transform) => {
        const view = viewOf(camera);
        const gizmo: Gizmo = { ...plain, joint: 0, axes: 'world' };
        const rings = gizmoRings(await evaluationOf(transform), view, gizmo);
        expect(rings.map(({ id }) => id)).toEqual([
          'joint view',
          ...[0, 1, 2].map((axis) => `joint world ${axis}`),
        ]);
        for (const { ring, first, second, center, id } of rings) {
          const across = vec3.cross([0, 0, 0], first, second);
          vec3.normalize(across, across);
          if (ring.axis !== null) {
            const axis = [0, 1, 2].map((i) => (i === ring.axis ? 1 : 0)) as [
              number,
              number,
              number,
            ];
            expect(vec3.dot(across, axis)).toBeCloseTo(1, 9);
            continue;
          }
          // Seen along its axis, it is a circle about the joint in the picture.
          const [cx, cy] = pixelsOf(view, center);
          const distances = gizmoLines(rings, gizmo)
            .filter((line) => line.id === id)
            .flatMap(({ points }) => points.map((point) => pixelsOf(view, point as vec3)))
            .map(([x, y]) => Math.hypot(x - cx, y - cy));
          expect(Math.max(...distances) / Math.min(...distances)).toBeCloseTo(1, 6);
          expect(Math.min(...distances)).toBeGreaterThan(radius * 1.2);
        }
      }),
      { numRuns: 40 },
    );
  });

  it('that coincide share their circle in dashes, neither over the other', async () => {
    const rest: Transform = { position: [0, 0, 0], rotation: [0, 0, 0, 1], scale: 1 };
    const evaluation = await evaluationOf(rest);
    const q = evaluation.state.q.slice();
    const { dofQ } = evaluation.state.character.skeleton;
    // R = Rz · Ry · Rx: the middle hinge of the root.
    const [, , , , middle] = dofQ;
    for (const angle of [Math.PI / 2, -Math.PI / 2]) {
      q[middle!] = angle;
      const locked = new Evaluator({ ...evaluation.state, q });
      const view = viewOf({ ...startCamera, distance: 3 });
      const gizmo = { ...plain, joint: 0 };
      const rings = gizmoRings(locked, view, gizmo);
      const dashed = rings.filter(({ dashes }) => dashes);
      expect(dashed.map(({ ring }) => ring.axis).sort()).toEqual([0, 2]);
      const { center, first, second } = dashed[0]!;
      const covered = dashed.map(({ id }) =>
        gizmoLines(rings, gizmo)
          .filter((line) => line.id === id && line.points.length === 3)
          .map(({ points }) => vec3.sub([0, 0, 0], points[1]!, center))
          .map((at) => Math.atan2(vec3.dot(at, second), vec3.dot(at, first))),
      );
      const [one, other] = [covered[0]!, covered[1]!];
      expect(one.length).toBeGreaterThan(15);
      const step = Math.PI / 24;
      const gaps = one.flatMap((a) =>
        other.map((b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)))),
      );
      expect(Math.min(...gaps)).toBeGreaterThan(step * 0.9);
    }
  });
});
