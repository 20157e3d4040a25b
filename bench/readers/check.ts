import type { Cylinder } from '../data/cylinder.ts';
import { expectRight } from '../harness/group.ts';
import type { ReadFile, ReaderKind } from './sinew.ts';

/** Texts have four to seven digits; the body is one unit tall. */
const tolerance = 1e-4;

/** Checks what the product's reader found against the body that the file was written from. */
export function checkReadFile(kind: ReaderKind, { mesh, skin }: ReadFile, body: Cylinder): void {
  if (kind !== 'attach') {
    const sign = kind === 'pmd' ? -1 : 1; // a PMD is left-handed
    const wanted = body.positions.map((value, i) => (i % 3 === 2 ? sign * value : value));
    checkNumbers(`${kind} positions`, mesh?.positions ?? [], wanted);
    expectRight(mesh?.cornerPoints.length === body.indices.length, `${kind} triangles`);
  }
  if (kind === 'obj') return;
  const rows = body.start.length - 1;
  expectRight(skin?.start.length === rows + 1, `${kind} has ${rows} rows of weights`);
  if (kind === 'pmd') return; // it keeps two influences of each vertex
  checkNumbers(`${kind} joints`, skin?.joints ?? [], body.joints);
  checkNumbers(`${kind} weights`, skin?.weights ?? [], body.weights);
}

/** Checks the peer's result by its size and by the numbers that are easy to find. */
export function checkPeerResult(kind: ReaderKind, result: unknown, body: Cylinder): void {
  const { positions, indices, vertexCount } = body;
  if (kind === 'obj') {
    const { children } = result as ThreeObject;
    const array = children[0]?.geometry.attributes.position.array ?? [];
    const corners = Float32Array.from({ length: indices.length * 3 }, (_, i) => {
      return positions[indices[Math.floor(i / 3)]! * 3 + (i % 3)]!;
    });
    checkNumbers('OBJLoader', array, corners);
  } else if (kind === 'attach') {
    const found = result as readonly (readonly number[])[];
    expectRight(found.length === vertexCount && found[0]!.length === 17, 'rows of split');
    const weights = found.flatMap((row) => row.filter((weight) => weight !== 0));
    checkNumbers('weights of split', weights, body.weights);
  } else if (kind === 'skin') {
    const found = result as readonly number[];
    checkNumbers('positions of split', found.slice(3, 3 + positions.length), positions);
  } else {
    const { vertices } = result as { vertices: readonly { position: readonly number[] }[] };
    checkNumbers(
      'mmd-parser',
      vertices.flatMap(({ position }) => position),
      positions,
    );
  }
}

interface ThreeObject {
  readonly children: readonly {
    readonly geometry: { readonly attributes: { readonly position: { array: Float32Array } } };
  }[];
}

function checkNumbers(what: string, found: ArrayLike<number>, wanted: ArrayLike<number>): void {
  expectRight(found.length === wanted.length, `${what}: ${found.length} for ${wanted.length}`);
  for (let i = 0; i < wanted.length; i++) {
    if (Math.abs(found[i]! - wanted[i]!) <= tolerance) continue;
    expectRight(false, `${what}: number ${i} is ${found[i]!}, not ${wanted[i]!}`);
  }
}
