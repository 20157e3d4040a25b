import { ByteWriter } from './byte-writer.ts';

type Text = string | readonly number[];
type Three = readonly [number, number, number];

export interface PmdVertex {
  readonly position: Three;
  readonly normal?: Three;
  readonly uv?: readonly [number, number];
  readonly bones?: readonly [number, number];
  readonly weight?: number;
  readonly edge?: number;
}

export interface PmdMaterial {
  readonly diffuse?: Three;
  readonly alpha?: number;
  readonly power?: number;
  readonly specular?: Three;
  readonly ambient?: Three;
  readonly toon?: number;
  readonly edge?: number;
  readonly count: number;
  readonly texture?: Text;
}

export interface PmdBoneContent {
  readonly name: Text;
  readonly parent: number;
  readonly tail?: number;
  readonly type?: number;
  readonly ikParent?: number;
  readonly head: Three;
}

export interface PmdMorphContent {
  readonly name: Text;
  readonly panel: number;
  readonly entries: readonly (readonly [index: number, vector: Three])[];
}

/** The content of a PMD in a plain form, in the file's left-handed space. */
export interface PmdContent {
  readonly version?: number;
  readonly name?: Text;
  readonly comment?: Text;
  readonly vertices: readonly PmdVertex[];
  readonly indices: readonly number[];
  readonly materials: readonly PmdMaterial[];
  readonly bones: readonly PmdBoneContent[];
  readonly ik?: readonly {
    readonly goal: number;
    readonly effector: number;
    readonly iterations: number;
    readonly limit: number;
    readonly links: readonly number[];
  }[];
  readonly morphs?: readonly PmdMorphContent[];
  readonly shownMorphs?: readonly number[];
  readonly groups?: readonly Text[];
  readonly listed?: readonly (readonly [bone: number, group: number])[];
  /** The last section of the file. */
  readonly last?: 'display' | 'english' | 'toons' | 'physics';
  /** Whether the file has English names. */
  readonly english?: boolean;
  readonly bodies?: readonly { readonly bone: number; readonly shape?: number }[];
  readonly springs?: readonly (readonly [number, number])[];
}

export type PmdSection = (typeof sections)[number];

const sections = [
  ...(['version', 'vertices', 'indices', 'materials', 'bones', 'ik', 'morphs', 'display'] as const),
  ...(['english', 'toons', 'physics', 'end'] as const),
];

/** Returns the bytes, and where each section starts in them. */
export function pmdFile(content: PmdContent): {
  bytes: Uint8Array;
  at: Readonly<Record<PmdSection, number>>;
} {
  const out = new ByteWriter();
  const at = Object.fromEntries(sections.map((name) => [name, -1])) as Record<PmdSection, number>;
  const mark = (name: PmdSection): void => {
    at[name] = out.size;
  };
  out.field(3, 'Pmd');
  mark('version');
  out.f32(content.version ?? 1);
  out.field(20, content.name ?? 'model').field(256, content.comment ?? 'a comment');
  mark('vertices');
  out.u32(content.vertices.length);
  for (const { position, normal, uv, bones, weight, edge } of content.vertices) {
    out.f32(...position, ...(normal ?? [0, 0, -1]), ...(uv ?? [0, 0]));
    out.u16(...(bones ?? [0, 0])).u8(weight ?? 100, edge ?? 0);
  }
  mark('indices');
  out.u32(content.indices.length);
  for (const index of content.indices) out.u16(index); // too many for one call
  mark('materials');
  out.u32(content.materials.length);
  for (const material of content.materials) {
    out.f32(...(material.diffuse ?? [1, 1, 1]), material.alpha ?? 1, material.power ?? 5);
    out.f32(...(material.specular ?? [0, 0, 0]), ...(material.ambient ?? [0.5, 0.5, 0.5]));
    out.u8(material.toon ?? 0, material.edge ?? 0).u32(material.count);
    out.field(20, material.texture ?? '');
  }
  mark('bones');
  out.u16(content.bones.length);
  for (const bone of content.bones) {
    out.field(20, bone.name).u16(bone.parent, bone.tail ?? 0);
    out.u8(bone.type ?? 0).u16(bone.ikParent ?? 0);
    out.f32(...bone.head);
  }
  mark('ik');
  out.u16(content.ik?.length ?? 0);
  for (const { goal, effector, iterations, limit, links } of content.ik ?? []) {
    out
      .u16(goal, effector)
      .u8(links.length)
      .u16(iterations)
      .f32(limit)
      .u16(...links);
  }
  mark('morphs');
  out.u16(content.morphs?.length ?? 0);
  for (const { name, panel, entries } of content.morphs ?? []) {
    out.field(20, name).u32(entries.length).u8(panel);
    for (const [index, vector] of entries) out.u32(index).f32(...vector);
  }
  mark('display');
  out.u8(content.shownMorphs?.length ?? 0).u16(...(content.shownMorphs ?? []));
  out.u8(content.groups?.length ?? 0);
  for (const group of content.groups ?? []) out.field(50, group);
  out.u32(content.listed?.length ?? 0);
  for (const [bone, group] of content.listed ?? []) out.u16(bone).u8(group);
  const { last = 'physics' } = content;
  if (last !== 'display') {
    mark('english');
    writeEnglish(out, content);
  }
  if (last === 'toons' || last === 'physics') {
    mark('toons');
    for (let toon = 1; toon <= 10; toon++) out.field(100, `toon${toon}.bmp`);
  }
  if (last === 'physics') {
    mark('physics');
    writePhysics(out, content);
  }
  mark('end');
  return { bytes: out.done(), at };
}

function writeEnglish(out: ByteWriter, { english, bones, morphs, groups }: PmdContent): void {
  if (!english) {
    out.u8(0);
    return;
  }
  out.u8(1).field(20, 'Model').field(256, 'A comment');
  bones.forEach((_, index) => out.field(20, `bone-${index}`));
  (morphs ?? []).slice(1).forEach((_, index) => out.field(20, `morph-${index}`));
  (groups ?? []).forEach((_, index) => out.field(50, `group-${index}`));
}

function writePhysics(out: ByteWriter, { bodies = [], springs = [] }: PmdContent): void {
  out.u32(bodies.length);
  for (const { bone, shape } of bodies) {
    out.field(20, 'body').u16(bone).u8(3).u16(0xfffe);
    out.u8(shape ?? 2);
    out.f32(1, 2, 3).f32(4, 5, 6).f32(0.1, 0.2, 0.3).f32(1, 0.5, 0.25, 0, 0.5).u8(1);
  }
  out.u32(springs.length);
  for (const pair of springs) {
    out.field(20, 'spring').u32(...pair);
    out.f32(1, 2, 3).f32(0.1, 0.2, 0.3);
    out.f32(-1, -2, -3).f32(4, 5, 6).f32(-0.1, -0.2, -0.3).f32(0.4, 0.5, 0.6);
    out.f32(7, 8, 9).f32(1, 2, 3);
  }
}

export const noBone = 0xffff;

/** "センター", "ﾈｸﾀｲ" (half-width), "左" and "右" in Shift-JIS. */
export const center = [0x83, 0x5a, 0x83, 0x93, 0x83, 0x5e, 0x81, 0x5b];
const tie = [0xc8, 0xb8, 0xc0, 0xb2];

/** A square with two materials on four bones in two trees, with every section. */
export const square: PmdContent = {
  name: center,
  vertices: [
    { position: [-1, 0, 2], uv: [0, 1], bones: [0, 1], weight: 100 },
    { position: [1, 0, 2], uv: [1, 1], bones: [0, 1], weight: 25, edge: 1 },
    { position: [1, 2, 2], uv: [1, 0], bones: [1, 2], weight: 70, normal: [0, 0.6, -0.8] },
    { position: [-1, 2, 2], uv: [-0.25, 0], bones: [2, 2], weight: 30, normal: [0, 0, -2] },
  ],
  // Seen from −z, the direction that characters face in the file's left-handed space.
  indices: [0, 2, 1, 0, 3, 2],
  materials: [
    {
      ...{ diffuse: [0.25, 0.5, 0.75], alpha: 0.5, power: 8, specular: [0.125, 0.25, 0.375] },
      ...{ ambient: [0.5, 0.25, 0.125], toon: 3, edge: 1, count: 3, texture: 'A.bmp*b.spa' },
    },
    { toon: 255, count: 3, texture: 'c.sph' },
  ],
  bones: [
    { name: center, parent: noBone, tail: 1, type: 1, head: [0, 0, 2] },
    { name: tie, parent: 0, tail: 2, type: 4, ikParent: 3, head: [0, 1, 2.5] },
    { name: tie, parent: 1, type: 6, head: [0.5, 2, 1] },
    { name: 'IK', parent: noBone, type: 2, head: [0.5, 2, 1] },
  ],
  ik: [{ goal: 3, effector: 2, iterations: 40, limit: 0.5, links: [1] }],
  morphs: [
    {
      ...{ name: 'base', panel: 0 },
      entries: [
        [3, [-1, 2, 2]],
        [1, [1, 0, 2]],
      ],
    },
    { name: 'smile', panel: 3, entries: [[1, [0.5, 0.25, 0.125]]] },
    { name: 'smile', panel: 2, entries: [] },
  ],
  shownMorphs: [2, 1],
  groups: ['body', 'legs'],
  listed: [
    [1, 1],
    [3, 2],
  ],
  english: true,
  bodies: [{ bone: 1 }, { bone: noBone, shape: 1 }],
  springs: [[0, 1]],
};

export const squarePmd: Uint8Array = pmdFile(square).bytes;

/** The bytes with others at a place. */
export function patched(bytes: Uint8Array, at: number, put: readonly number[]): Uint8Array {
  const copy = bytes.slice();
  copy.set(put, at);
  return copy;
}
