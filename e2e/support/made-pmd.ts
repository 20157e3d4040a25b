import { PNG } from 'pngjs';
import { noBone, type PmdContent, pmdFile } from '../../tests/support/pmd-files.ts';
import { ByteWriter } from '../../tests/support/byte-writer.ts';
import type { NamedFile } from './app.ts';

type Three = readonly [number, number, number];
type Vertex = PmdContent['vertices'][number];
type Material = Omit<PmdContent['materials'][number], 'count'>;

interface Part {
  readonly material: Material;
  readonly vertices: readonly Vertex[];
  /** Indices into the part's own vertices, clockwise seen from outside, as in the file. */
  readonly indices: readonly number[];
}

/** "右肩" and "右手首" in Shift-JIS. */
const shoulder = [0x89, 0x45, 0x8c, 0xa8];
const wrist = [0x89, 0x45, 0x8e, 0xe8, 0x8e, 0xf1];

const bones: PmdContent['bones'] = [
  { name: 'center', parent: noBone, tail: 1, type: 1, head: [0, 8, 0] },
  { name: shoulder, parent: 0, tail: 2, head: [3, 12, 0] },
  { name: wrist, parent: 1, head: [6, 12, 0] },
  { name: 'other', parent: 0, head: [-4, 11, 0] },
];

const plain = { diffuse: [1, 1, 1], ambient: [0.5, 0.5, 0.5] } as const;

/** A plate with an image, a block, a shiny ball, a translucent ball, and an invisible plate. */
function partsWith(image: string): readonly Part[] {
  return [
    { material: { ...plain, texture: image }, ...plate([-7, 5, 0], [-1, 11, 0], 3) },
    {
      material: { diffuse: [0.55, 0.35, 0.2], ambient: [0.2, 0.12, 0.08] },
      ...ball([0, 2.4, 0.5], 2.4, 0, 4),
    },
    {
      material: {
        ...{ diffuse: [0.15, 0.2, 0.7], ambient: [0.05, 0.07, 0.3] },
        ...{ specular: [1, 1, 1], power: 40 },
      },
      ...ball([4, 11, 0], 3, 1),
    },
    {
      material: { diffuse: [0.2, 0.8, 0.3], ambient: [0.1, 0.4, 0.15], alpha: 0.5 },
      ...ball([0.5, 8, -4], 2.6, 0),
    },
    { material: { diffuse: [1, 0, 0], alpha: 0 }, ...plate([-8, 0, -8], [8, 14, -8], 0) },
  ];
}

/** The character and its image, "plate.png" or "plate.tga"; both contain the same picture. */
export function madePmd(ending: 'png' | 'tga' = 'png'): [pmd: NamedFile, image: NamedFile] {
  const image = `plate.${ending}`;
  return [
    { name: 'made.pmd', content: pmdOf(partsWith(image)) },
    { name: image, content: ending === 'png' ? quartersPng() : quartersTga() },
  ];
}

/** The same bones without a mesh. */
export function madeBones(): NamedFile {
  return { name: 'bones.pmd', content: pmdOf([]) };
}

function pmdOf(parts: readonly Part[]): Uint8Array {
  const vertices: Vertex[] = [];
  const indices: number[] = [];
  for (const part of parts) {
    indices.push(...part.indices.map((index) => vertices.length + index));
    vertices.push(...part.vertices);
  }
  const materials = parts.map(({ material, indices: own }) => ({ ...material, count: own.length }));
  return pmdFile({ vertices, indices, materials, bones, last: 'toons' }).bytes;
}

/**
 * An upright plate that faces −z. The image repeats 1.5 times across, with its upper edge at the
 * top.
 */
function plate([left, low, z]: Three, [right, high]: Three, bone: number): Omit<Part, 'material'> {
  const corner = (x: number, y: number, u: number, v: number): Vertex => ({
    ...{ position: [x, y, z], uv: [u, v], bones: [bone, bone] },
  });
  return {
    vertices: [
      corner(left, low, 0, 1),
      corner(right, low, 1.5, 1),
      corner(right, high, 1.5, 0),
      corner(left, high, 0, 0),
    ],
    indices: [0, 2, 1, 0, 3, 2],
  };
}

function ball([x, y, z]: Three, radius: number, bone: number, steps = 16): Omit<Part, 'material'> {
  const vertices: Vertex[] = [];
  const indices: number[] = [];
  const columns = 2 * steps;
  for (let row = 0; row <= steps; row++) {
    for (let column = 0; column <= columns; column++) {
      const [down, around] = [(row / steps) * Math.PI, (column / steps) * Math.PI];
      const level = Math.sin(down);
      const normal: Three = [Math.sin(around) * level, Math.cos(down), Math.cos(around) * level];
      const position: Three = [
        x + radius * normal[0],
        y + radius * normal[1],
        z + radius * normal[2],
      ];
      vertices.push({ position, normal, bones: [bone, bone] });
      if (row === steps || column === columns) continue;
      const at = row * (columns + 1) + column;
      const below = at + columns + 1;
      indices.push(at, below, below + 1, at, below + 1, at + 1);
    }
  }
  return { vertices, indices };
}

/** The quarters are red and green at the top, blue and yellow at the bottom. */
const colors = [
  [230, 40, 40],
  [40, 200, 60],
  [50, 80, 230],
  [240, 220, 60],
] as const;
const size = 16;

function quarter(x: number, y: number): readonly [number, number, number] {
  return colors[(y < size / 2 ? 0 : 2) + (x < size / 2 ? 0 : 1)]!;
}

function quartersPng(): Uint8Array {
  const image = new PNG({ width: size, height: size });
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) image.data.set([...quarter(x, y), 255], (y * size + x) * 4);
  }
  return PNG.sync.write(image);
}

/** The image is compressed, starts at the top row, and has 24 bits per pixel. */
function quartersTga(): Uint8Array {
  const out = new ByteWriter().u8(0, 0, 10).u16(0, 0).u8(0).u16(0, 0, size, size).u8(24, 32);
  for (let y = 0; y < size; y++) {
    for (const x of [0, size / 2]) out.u8(128 + size / 2 - 1, ...[...quarter(x, y)].reverse());
  }
  return out.done();
}
