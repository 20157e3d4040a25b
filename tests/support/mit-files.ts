import fc from 'fast-check';
import type { FileContents } from './files.ts';

const number = fc.oneof(
  fc.float({ noNaN: true, noDefaultInfinity: true, min: Math.fround(-1e6), max: Math.fround(1e6) }),
  fc.integer({ min: -3, max: 3 }),
);
const triple = fc.tuple(number, number, number);
const lines = (rows: readonly (readonly (number | string)[])[]): string =>
  rows.map((row) => `${row.join(' ')}\n`).join('');

/**
 * Two or more joints, so that rows have a column; parents come all before or all after their
 * children.
 */
const skel = fc
  .tuple(fc.array(fc.tuple(triple, fc.nat()), { minLength: 2, maxLength: 8 }), fc.boolean())
  .map(([joints, rootFirst]) => {
    const last = joints.length - 1;
    const numbered = (index: number): number => (rootFirst ? index : last - index);
    const rows = joints.map(([offset, choice], index) => {
      const parent = index === 0 ? -1 : numbered(choice % index);
      return [...offset, parent];
    });
    return rootFirst ? rows : rows.toReversed();
  });

/** Enough rows and columns for every character here. */
const eight = { minLength: 8, maxLength: 8 };

const material = fc.constantFrom('', 'a', 'b c', '#', '__proto__');

const channel = fc.double({ min: 0, max: 1, noNaN: true });
const color = fc.tuple(channel, channel, channel);

/** Any material library; the first line of each material has its name. */
const library = fc
  .array(
    fc.record(
      {
        newmtl: material.map((name) => [name]),
        Kd: color,
        Ks: color,
        Ka: color,
        Ns: fc.tuple(fc.nat()),
        d: fc.tuple(channel),
        map_Kd: fc.constantFrom(['a.png'], ['b c.tga']),
      },
      { requiredKeys: ['newmtl'] },
    ),
    { minLength: 1, maxLength: 3 },
  )
  .map((materials) => {
    return materials.flatMap(({ newmtl, ...rest }) => [['newmtl', ...newmtl], ...rowsOf(rest)]);
  });

function rowsOf(values: Readonly<Record<string, readonly (number | string)[]>>) {
  return Object.entries(values).map(([keyword, numbers]) => [keyword, ...numbers]);
}

/** Any valid `.skel`, `.obj` (with texture coordinates and materials), `.mtl` and `.attach`. */
export const mitFiles: fc.Arbitrary<FileContents> = fc
  .record({
    skel,
    points: fc.array(triple, { minLength: 3, maxLength: 8 }),
    uvs: fc.array(fc.tuple(number, number), { minLength: 1, maxLength: 5 }),
    faces: fc.array(fc.record({ material, corners: fc.array(fc.nat(), { minLength: 4 }) }), {
      minLength: 1,
      maxLength: 6,
    }),
    rows: fc.array(fc.array(fc.oneof(number, fc.constant(0)), eight), eight),
    withUvs: fc.boolean(),
    library: fc.option(library),
  })
  .map(({ skel, points, uvs, faces, rows, withUvs, library }) => {
    const corner = (point: number, choice: number): string =>
      withUvs ? `${point + 1}/${(choice % uvs.length) + 1}` : `${point + 1}`;
    const faceLines = faces.flatMap(({ material, corners: [first, ...choices] }) => {
      const face = choices
        .slice(0, 3)
        .map((choice, i) => corner((first! + i) % points.length, choice));
      return [
        ['usemtl', material],
        ['f', ...face],
      ];
    });
    return {
      'a.skel': lines(skel),
      ...(library ? { 'a.mtl': lines(library) } : {}),
      'a.obj': lines([
        ...(library ? [['mtllib', 'a.mtl']] : []),
        ...points.map((point) => ['v', ...point]),
        ...uvs.map((uv) => ['vt', ...uv]),
        ...faceLines,
      ]),
      'a.attach': lines(points.map((_, point) => rows[point]!.slice(0, skel.length - 1))),
    };
  });
