import { describe, expect, it } from 'vitest';
import type { Character } from '../../src/core/character.ts';
import type { FaceWeighting } from '../../src/core/vertex-normals.ts';
import { createActor } from '../../src/document/scene.ts';
import { Evaluator } from '../../src/evaluation/evaluator.ts';
import { normalWays, recomputedNormals } from '../../src/skinning/registry.ts';
import { recomputeNormals, weldOf } from '../../src/skinning/welded-normals.ts';
import { bentTube, type Split } from '../fixtures/bent-tube.ts';
import { rotationAbout, transform, unit } from '../reference/matrix.ts';
import { faceWeights, meanNormal } from '../reference/normals.ts';
import { largestDifference, numbersAt } from '../support/compare.ts';
import { readOne } from '../support/files.ts';
import { fullPool } from '../support/kernels.ts';
import { tolerances } from '../tolerances.ts';

const ways = normalWays.flatMap(({ id }) => recomputedNormals(id) ?? []);

/** Posed by the evaluation: bent by 2 radians and twisted. */
function posed(character: Character, normals: FaceWeighting) {
  const q = character.skeleton.qRest.slice();
  [q[q.length - 3], q[q.length - 2]] = [2, 0.7];
  const actor = createActor(1, character, 'linear-blend', { q, normals });
  return new Evaluator(actor, fullPool()).vertices();
}

/** The oracle's normals, where corners belong together if their bind positions are equal. */
function expectedNormals({ mesh }: Character, positions: Float32Array, way: string): number[] {
  const at = (values: Float32Array, vertex: number) => numbersAt(values, vertex, 3);
  const faces = Array.from(
    { length: mesh.indices.length / 3 },
    (_, face) => numbersAt(mesh.indices, face, 3) as [number, number, number],
  );
  const places = Array.from({ length: mesh.vertexCount }, (_, vertex) => at(positions, vertex));
  const bind = places.map((_, vertex) => at(mesh.positions, vertex).join());
  return bind.flatMap((here) =>
    unit(meanNormal(faces, places, (corner) => bind[corner] === here, way)),
  );
}

function recomputed(character: Character, way: FaceWeighting, positions: readonly number[]) {
  const normals = new Float32Array(positions.length);
  recomputeNormals(character, way, { positions: Float32Array.from(positions), normals });
  return normals;
}

it('every recomputed way of the registry has an oracle', () => {
  expect(ways).toEqual(Object.keys(faceWeights));
});

describe.each(ways)('normals recomputed from posed faces, %s', (way) => {
  it.each<Split>(['none', 'by texture coordinates', 'by points'])(
    'agree with the oracle on a bent tube, split: %s',
    async (split) => {
      const character = await bentTube(split);
      const { positions, normals } = posed(character, way);
      const expected = expectedNormals(character, positions, way);
      expect(largestDifference(normals, expected)).toBeLessThan(tolerances.normals);
    },
  );

  it('are the same where a seam splits points as where none does, bit by bit at the copies', async () => {
    const whole = posed(await bentTube('none'), way);
    for (const split of ['by texture coordinates', 'by points'] as const) {
      const character = await bentTube(split);
      const { mesh } = character;
      expect(mesh.vertexCount).toBeGreaterThan(whole.positions.length / 3);
      const { normals } = posed(character, way);
      const begins = normals.subarray(0, whole.normals.length);
      expect(largestDifference(begins, whole.normals)).toBeLessThan(tolerances.normals);
      const { groupOf } = weldOf(character);
      for (let vertex = whole.normals.length / 3; vertex < mesh.vertexCount; vertex++) {
        const other = groupOf.indexOf(groupOf[vertex]!);
        expect(other).toBeLessThan(vertex);
        expect(numbersAt(normals, vertex, 3)).toEqual(numbersAt(normals, other, 3));
      }
    }
  });

  it('turn with a rigid motion of all vertices, and do not change with their size', async () => {
    const character = await bentTube('by points');
    const { positions, normals } = posed(character, way);
    const turn = rotationAbout(unit([1, 2, -0.5]), 1.1);
    const triples = (values: Float32Array): number[][] =>
      Array.from({ length: values.length / 3 }, (_, i) => numbersAt(values, i, 3));
    const moved = triples(positions).flatMap((place) =>
      transform(turn, place).map((value, axis) => 3 * value + axis),
    );
    const expected = triples(normals).flatMap((normal) => transform(turn, normal, 0));
    expect(largestDifference(recomputed(character, way, moved), expected)).toBeLessThan(
      tolerances.normals,
    );
  });

  it('are finite and of unit length if all vertices fall together or a few coordinates are huge', async () => {
    const character = await bentTube('by points');
    const { vertexCount } = character.mesh;
    const up = Array.from({ length: vertexCount }, () => [0, 1, 0]).flat();
    expect([
      ...recomputed(
        character,
        way,
        up.map(() => 0.3),
      ),
    ]).toEqual(up);
    const wild = up.map((_, i) => (i % 7 === 0 ? 3e38 : i % 5 === 0 ? 1e-40 : Math.sin(i)));
    const normals = recomputed(character, way, wild);
    for (let i = 0; i < normals.length; i += 3) {
      expect(Math.hypot(...normals.slice(i, i + 3))).toBeCloseTo(1, 5);
    }
  });
});

describe('the ways differ', () => {
  const files = {
    'a.skel': '0 0 0 -1\n0 0 0 0\n',
    'a.attach': '1\n1\n1\n1\n1\n',
  };
  const square = (faces: string): Promise<Character> =>
    readOne({
      ...files,
      'a.obj': `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.9 0\n${faces}`,
    });

  it('only by angle does the cut of a flat face not matter', async () => {
    // The corner at the origin has a face in each coordinate plane; one of them is cut in two.
    const whole = await square('f 1 3 2\nf 1 2 4\nf 1 4 3\nf 5 3 2\n');
    const cut = await square('f 1 3 5\nf 1 5 2\nf 1 2 4\nf 1 4 3\n');
    const atOrigin = (character: Character, way: FaceWeighting): number[] =>
      numbersAt(posedAtRest(character, way), 0, 3);
    const difference = (way: FaceWeighting): number =>
      largestDifference(atOrigin(whole, way), atOrigin(cut, way));
    expect(difference('angle')).toBeLessThan(tolerances.float32);
    expect(difference('faces')).toBeGreaterThan(0.05);
    const corner = unit([-1, -1, -1]);
    expect(largestDifference(atOrigin(cut, 'angle'), corner)).toBeLessThan(tolerances.float32);
  });

  function posedAtRest({ mesh, ...others }: Character, way: FaceWeighting): number[] {
    return [...recomputed({ mesh, ...others }, way, [...mesh.positions])];
  }
});

describe('what is welded', () => {
  // Two triangles that meet at an edge, with points of their own there.
  const open = (
    rows: string,
    tip = '0 -1 0.5',
    normals?: readonly string[],
  ): Promise<Character> => {
    const slash = (index: number): string => (normals ? `//${index}` : '');
    return readOne({
      'a.skel': '0 0 0 -1\n0 0 0 0\n0 1 0 0\n',
      'a.obj':
        `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv ${tip}\n` +
        (normals ?? []).map((normal) => `vn ${normal}\n`).join('') +
        `f 1${slash(1)} 2${slash(1)} 3${slash(1)}\nf 4${slash(2)} 6${slash(2)} 5${slash(2)}\n`,
      'a.attach': rows,
    });
  };
  const groups = ({ mesh, skin }: Character): number[] => [...weldOf({ mesh, skin }).groupOf];
  const alike = '1 0\n0.5 0.5\n1 0\n1 0\n0.5 0.5\n1 0\n';
  const [welded, split] = [
    [0, 1, 2, 0, 1, 3],
    [0, 1, 2, 3, 4, 5],
  ];

  it('are copies of a place with weights alike', async () => {
    expect(groups(await open(alike))).toEqual(welded);
    const rounded = alike.replace(/0\.5 0\.5\n1 0\n$/, '0.52 0.48\n1 0\n');
    expect(groups(await open(rounded))).toEqual(welded);
  });

  it('are not copies that other joints move, as lips', async () => {
    expect(groups(await open('1 0\n1 0\n1 0\n0 1\n0 1\n0 1\n'))).toEqual(split);
  });

  it('are copies at any edge if the file has no normals', async () => {
    expect(groups(await open(alike, '0 0 1'))).toEqual(welded);
  });

  it('are not copies with other normals in the file, which are a crease', async () => {
    expect(groups(await open(alike, '0 -1 0.5', ['0 0 1', '0 0.1 1']))).toEqual(split);
    expect(groups(await open(alike, '0 -1 0.5', ['0 1 1', '0 1.001 1']))).toEqual(welded);
  });
});
