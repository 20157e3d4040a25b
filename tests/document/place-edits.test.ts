import { vec3 } from 'gl-matrix';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { PlaceAngles } from '../../src/document/place-angles.ts';
import {
  angleBetween,
  legalScales,
  movedBy,
  scaledBy,
  snapped,
  turnedBy,
} from '../../src/document/place-edits.ts';
import { type Transform, unmoved } from '../../src/document/scene.ts';
import { type Matrix, multiply, rotationAbout, rotationOf } from '../reference/matrix.ts';

const number = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const triple = (size: number) =>
  fc.tuple(number(-size, size), number(-size, size), number(-size, size));
const unit = triple(1)
  .filter((vector) => vec3.length(vector) > 0.1)
  .map((vector) => vec3.normalize(new Float64Array(3), vector));
const transforms: fc.Arbitrary<Transform> = fc.record({
  position: triple(5),
  rotation: fc
    .tuple(number(-1, 1), number(-1, 1), number(-1, 1), number(0.1, 1))
    .map(([x, y, z, w]) => {
      const size = Math.hypot(x, y, z, w);
      return [x / size, y / size, z / size, w / size] as const;
    }),
  scale: number(0.1, 5),
});

describe('moving', () => {
  it('and moving back is the identity, and turns and scales nothing', () => {
    fc.assert(
      fc.property(transforms, triple(3), (start, [x, y, z]) => {
        const there = movedBy(start, [x, y, z]);
        expect([there.rotation, there.scale]).toEqual([start.rotation, start.scale]);
        const back = movedBy(there, [-x, -y, -z]);
        back.position.forEach((value, i) => expect(value).toBeCloseTo(start.position[i]!, 12));
      }),
    );
  });

  it('on a grid gives multiples where it moves, and keeps the bits of the rest', () => {
    fc.assert(
      fc.property(transforms, number(-3, 3), number(-3, 3), (start, x, z) => {
        const there = movedBy(start, [x, 0, z], 0.1);
        expect(there.position[1]).toBe(start.position[1]);
        for (const [i, by] of [
          [0, x],
          [2, z],
        ] as const) {
          if (by === 0) continue;
          // The nearest number to a tenth, as somebody would type it.
          expect(there.position[i]).toBe(Number(there.position[i].toFixed(1)) + 0);
          expect(Math.abs(there.position[i] - start.position[i] - by)).toBeLessThan(0.05 + 1e-9);
        }
      }),
    );
  });
});

describe('turning', () => {
  it('composes as rotations do, about axes of the scene and of the character', () => {
    fc.assert(
      fc.property(transforms, unit, number(-7, 7), fc.boolean(), (start, axis, angle, isOwn) => {
        const { rotation, position, scale } = turnedBy(start, axis, angle, isOwn);
        expect([position, scale]).toEqual([start.position, start.scale]);
        expect(Math.hypot(...rotation)).toBeCloseTo(1, 12);
        const [before, by] = [rotationOf(start.rotation), rotationAbout([...axis], angle)];
        expectSame(rotationOf(rotation), isOwn ? multiply(before, by) : multiply(by, before), 10);
      }),
    );
  });

  it('by nothing keeps the bits, and its angle is read back', () => {
    fc.assert(
      fc.property(transforms, unit, number(-3, 3), (start, axis, angle) => {
        expect(turnedBy(start, axis, 0)).toBe(start);
        expect(angleBetween(start, turnedBy(start, axis, angle), axis)).toBeCloseTo(angle, 9);
      }),
    );
  });
});

describe('scaling', () => {
  it('and scaling back is the identity; steps are multiples, and never nothing', () => {
    fc.assert(
      fc.property(transforms, number(0.2, 5), (start, factor) => {
        const back = scaledBy(scaledBy(start, factor), 1 / factor);
        expect(back.scale).toBeCloseTo(start.scale, 12);
        expect(back.position).toBe(start.position);
        const { scale } = scaledBy(start, factor, 0.1);
        expect(scale).toBe(snapped(scale, 0.1));
        expect(scale).toBeGreaterThanOrEqual(0.1);
      }),
    );
    expect(scaledBy(unmoved, 1e9).scale).toBe(legalScales[1]);
    expect(scaledBy(unmoved, 1e-9).scale).toBe(legalScales[0]);
  });
});

describe('the three angles of a place', () => {
  it('give R = Ry · Rx · Rz, and are found again in it', () => {
    fc.assert(
      fc.property(
        number(-Math.PI, Math.PI),
        number(-1.5, 1.5),
        number(-Math.PI, Math.PI),
        (y, x, z) => {
          const angles = new PlaceAngles();
          let placed = angles.withAngle(1, unmoved, 1, y);
          placed = angles.withAngle(1, placed, 0, x);
          placed = angles.withAngle(1, placed, 2, z);
          const expected = product(y, x, z);
          expectSame(rotationOf(placed.rotation), expected, 12);
          expect(angles.of(1, placed.rotation), 'to the bit').toEqual([x, y, z]);
          // Other angles may give the same rotation.
          const [x2, y2, z2] = new PlaceAngles().of(1, placed.rotation);
          expectSame(product(y2, x2, z2), expected, 9);
        },
      ),
    );
  });

  it('stay apart where a turn goes past a half, and a right angle leans', () => {
    const angles = new PlaceAngles();
    let placed = unmoved;
    for (let turn = 0; turn < 40; turn++) placed = turnedBy(placed, [0, 1, 0], 0.1);
    const [x, y, z] = angles.of(1, placed.rotation);
    expect([x, z].every((angle) => Math.abs(angle) < 1e-9)).toBe(true);
    expect(Math.cos(y)).toBeCloseTo(Math.cos(4), 9);
    const lying = angles.withAngle(1, placed, 0, Math.PI / 2);
    const turned = angles.withAngle(1, lying, 1, 0.25);
    expect(angles.of(1, turned.rotation).slice(0, 2)).toEqual([Math.PI / 2, 0.25]);
    expect(angles.of(1, lying.rotation)[1]).toBe(y);
  });
});

function expectSame(a: Matrix, b: Matrix, digits: number): void {
  a.flat().forEach((value, i) => expect(value).toBeCloseTo(b.flat()[i]!, digits));
}

/** Ry · Rx · Rz. */
function product(y: number, x: number, z: number): Matrix {
  const leaned = multiply(rotationAbout([1, 0, 0], x), rotationAbout([0, 0, 1], z));
  return multiply(rotationAbout([0, 1, 0], y), leaned);
}
