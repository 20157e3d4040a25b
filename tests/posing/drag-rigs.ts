import { vec3 } from 'gl-matrix';
import { buildCharacter } from '../../src/core/build-character.ts';
import type { DofParts, JointParts } from '../../src/core/character-parts.ts';
import { DofKind, type Skeleton } from '../../src/core/skeleton.ts';
import type { DragPointer, DragStart } from '../../src/posing/drag.ts';
import type { Freedom, Joint, Values } from '../reference/kinematics.ts';
import { type Matrix, transform, unit } from '../reference/matrix.ts';
import { characterFromJoints } from '../reference/kinematics.ts';
import {
  randomBetween,
  randomRotation,
  randomSource,
  randomUnitVector,
} from '../support/random.ts';

type Triple = readonly [number, number, number];

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

/**
 * The kinds of joints that formats have: letters are hinges, `s` is three slides, `b` is a ball.
 */
export const turningKinds = ['b', 'sb', 'xyz', 'zyx', 'sxyz', 'zxy', 'yzx'] as const;

/** A parent and the joint that is dragged, both rotated at rest and posed. */
export interface DragRig {
  readonly skeleton: Skeleton;
  readonly q: Float64Array;
  readonly joints: readonly Joint[];
  /** The dragged joint. */
  readonly joint: 1;
}

/** @param limits of every hinge of the dragged joint, relative to its value */
export function dragRig(kind: string, seed: number, limits?: readonly [number, number]): DragRig {
  const random = randomSource(seed);
  const freedoms = Array.from(kind).flatMap((letter): Freedom[] => {
    if (letter === 's') return Object.values(axes).map((axis) => ({ kind: 'slide', axis }));
    if (letter === 'b') return [{ kind: 'ball' }];
    return [{ kind: 'hinge', axis: axes[letter as keyof typeof axes] }];
  });
  const offset = (): number[] => [0, 1, 2].map(() => randomBetween(random, -0.4, 0.4));
  const joints: Joint[] = [-1, 0].map((parent) => ({
    parent,
    offset: offset(),
    rotation: randomRotation(random, 3),
    freedoms: parent === -1 ? [{ kind: 'ball' }] : freedoms,
  }));
  const rest: number[][][] = joints.map((each) =>
    each.freedoms.map((freedom) => {
      if (freedom.kind === 'ball') return randomRotation(random, 2);
      return [randomBetween(random, -1, 1) * (freedom.kind === 'slide' ? 0.2 : 1)];
    }),
  );
  const dofs = (joint: number): DofParts[] =>
    joints[joint]!.freedoms.map((freedom, i) => {
      const value = rest[joint]![i]!;
      const isHinge = freedom.kind === 'hinge';
      return {
        kind: DofKind[freedom.kind],
        axis: freedom.kind === 'ball' ? [0, 0, 0] : triple(freedom.axis),
        rest: value,
        ...(limits && isHinge
          ? { limits: [value[0]! + limits[0], value[0]! + limits[1]] as const }
          : {}),
      };
    });
  const parts = joints.map((each, i): JointParts => {
    const [x, y, z, w] = each.rotation;
    return {
      name: `joint ${i}`,
      parent: each.parent,
      restOffset: triple(each.offset),
      restRotation: [x!, y!, z!, w!],
      dofs: dofs(i),
    };
  });
  const { value } = buildCharacter({
    name: 'rig',
    missing: [],
    skeleton: { file: 'rig', joints: parts },
  });
  const { skeleton } = value!;
  return { skeleton, q: skeleton.qRest.slice(), joints, joint: 1 };
}

/** Converts the values to the form of the oracle. */
function valuesOf({ joints }: DragRig, q: Float64Array): Values {
  let at = 0;
  return joints.map(({ freedoms }) =>
    freedoms.map(({ kind }) => {
      const size = kind === 'ball' ? 4 : 1;
      at += size;
      return [...q.subarray(at - size, at)];
    }),
  );
}

/** The oracle's matrix of the dragged joint. */
export function worldOf(rig: DragRig, q: Float64Array): Matrix {
  return characterFromJoints(rig.joints, valuesOf(rig, q))[1]!;
}

/**
 * A view of 800 pixels that looks at `center` from a distance of three units in the direction
 * `away` (a unit vector).
 */
export class TestView {
  readonly eye: readonly number[];
  readonly look: Triple;
  readonly right: Triple;
  readonly up: Triple;
  private readonly pixelsPerSlope = 800 / (2 * Math.tan(0.3));

  constructor(center: readonly number[], away: readonly number[]) {
    this.eye = center.map((value, i) => value + away[i]! * 3);
    this.look = triple(away.map((value) => -value));
    this.right = triple(unit(cross(this.look, Math.abs(away[1]!) < 0.9 ? [0, 1, 0] : [1, 0, 0])));
    this.up = triple(cross(this.right, this.look));
  }

  /** The position of a point in the picture: pixels to the right and up from the center. */
  pixelsOf(point: ArrayLike<number>): [number, number] {
    const away = this.eye.map((value, i) => point[i]! - value);
    const scale = this.pixelsPerSlope / dot(away, this.look);
    return [dot(away, this.right) * scale, dot(away, this.up) * scale];
  }

  pointerAt(x: number, y: number): DragPointer {
    const direction = unit(
      this.look.map(
        (value, i) => value + (this.right[i]! * x + this.up[i]! * y) / this.pixelsPerSlope,
      ),
    );
    return { ray: { origin: triple(this.eye), direction: triple(direction) }, x, y };
  }

  pointerOver(point: ArrayLike<number>): DragPointer {
    return this.pointerAt(...this.pixelsOf(point));
  }
}

/** The start of a drag with the pointer over a point of the joint, given in the joint's frame. */
export function startOver(
  rig: DragRig,
  held: readonly number[],
  viewSeed: number,
  away = randomUnitVector(randomSource(viewSeed)),
): { start: Omit<DragStart, 'mode'>; view: TestView; world: Matrix; pivot: number[] } {
  const world = worldOf(rig, rig.q);
  const pivot = transform(world, [0, 0, 0]);
  const view = new TestView(pivot, away);
  const grabbed = triple(transform(world, held));
  const { skeleton, q, joint } = rig;
  const start = { skeleton, q, joint, grabbed, view, pointer: view.pointerOver(grabbed) };
  return { start, view, world, pivot };
}

export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return vec3.dot([a[0]!, a[1]!, a[2]!], [b[0]!, b[1]!, b[2]!]);
}

function cross(a: readonly number[], b: readonly number[]): number[] {
  return [
    a[1]! * b[2]! - a[2]! * b[1]!,
    a[2]! * b[0]! - a[0]! * b[2]!,
    a[0]! * b[1]! - a[1]! * b[0]!,
  ];
}

function triple(values: readonly number[]): Triple {
  return [values[0]!, values[1]!, values[2]!];
}
