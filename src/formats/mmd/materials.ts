import type {
  Color,
  MaterialColors,
  MaterialParts,
  MeshParts,
} from '../../core/character-parts.ts';
import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { BinaryReader } from '../binary/binary-reader.ts';
import type { BinaryRecord } from '../binary/binary-record.ts';
import { uniqueNames } from '../unique-names.ts';
import { decodeName } from './decode-name.ts';
import { Findings } from './findings.ts';
import { readTextures, textureFieldSize } from './texture-field.ts';

export interface PmdMaterials {
  readonly materials: readonly MaterialParts[];
  readonly submeshes: NonNullable<MeshParts['submeshes']>;
}

const size = 70;

/** A larger number is not a color, and lighting would overflow with it. */
const largestColor = 1e6;

/** The light of MikuMikuDance at its start, in each channel. */
const programLight = 154 / 255;

/** Replaces colors that are not numbers: plain gray. */
const fallback: MaterialColors = withShown({
  diffuse: [0.8, 0.8, 0.8],
  alpha: 1,
  specular: [0, 0, 0],
  shininess: 5,
  ambient: [0.4, 0.4, 0.4],
});

/**
 * Reads the materials, each of which applies to the next given number of corners. Triangles after
 * the last material get one of their own.
 */
export function readMaterials(
  reader: BinaryReader,
  cornerCount: number,
  log: DiagnosticLog,
  effect: string,
): PmdMaterials | undefined {
  const array = reader.array(4, size, 'materials');
  if (!array) return undefined;
  const { count, offset, records } = array;
  const findings = new MaterialFindings();
  const materials: Omit<MaterialParts, 'name'>[] = [];
  const firstTriangles: number[] = [];
  let corners = 0;
  for (let index = 0; index < count; index++) {
    const at = index * size;
    firstTriangles.push(corners / 3);
    materials.push(readMaterial(records, at, index, findings));
    const own = records.u32(at + 46);
    corners += own;
    if (own % 3 === 0 && corners <= cornerCount) continue;
    const expected =
      own % 3 === 0
        ? `at most ${cornerCount - corners + own} indices for material ${index}, those that are left`
        : `three indices for each triangle of material ${index}`;
    const place = { offset: records.offset + at + 46 };
    log.error({ code: 'pmd/count', ...place, expected, found: `${own}`, effect });
    return undefined;
  }
  findings.warn(log);
  if (corners < cornerCount) {
    const expected = `materials for all ${cornerCount} indices`;
    const rest = 'the other triangles get a material of their own';
    log.warn({ code: 'pmd/count', offset, expected, found: `${corners}`, effect: rest });
    firstTriangles.push(corners / 3);
    materials.push({ ...shadedBy(fallback), toon: -1, hasEdge: false });
  }
  const names = uniqueNames(
    materials.map(() => ''),
    'material',
  );
  return {
    materials: materials.map((material, index) => ({ name: names[index]!, ...material })),
    submeshes: firstTriangles.map((firstTriangle, index) => {
      return { material: names[index]!, firstTriangle };
    }),
  };
}

class MaterialFindings {
  readonly colors = new Findings();
  readonly alphas = new Findings();
  readonly toons = new Findings();

  warn(log: DiagnosticLog): void {
    this.colors.warn(log, 'pmd/number', 'colors that are numbers', 'gray is used');
    this.alphas.warn(log, 'pmd/range', 'alpha from 0 to 1', 'the nearest of them is used');
    this.toons.warn(log, 'pmd/index', 'a toon from 0 to 9, or none (255)', 'none is used');
  }
}

function readMaterial(
  records: BinaryRecord,
  at: number,
  index: number,
  findings: MaterialFindings,
): Omit<MaterialParts, 'name'> {
  const offset = records.offset + at;
  const toon = records.u8(at + 44);
  if (toon > 9 && toon !== 255) findings.toons.add(offset + 44, `${toon}, material ${index}`);
  return {
    ...shadedBy(readColors(records, at, index, findings)),
    toon: toon > 9 ? -1 : toon,
    hasEdge: records.u8(at + 45) !== 0,
    ...readTextures(decodeName(records.bytes(at + 50, textureFieldSize))),
  };
}

/**
 * Models for MikuMikuDance have linings close below their surfaces and rely on it not to draw the
 * inner sides of opaque surfaces.
 */
function shadedBy(colors: MaterialColors): Pick<MaterialParts, 'colors' | 'twoSided'> {
  return { colors, twoSided: colors.alpha < 1 };
}

/** In full light, the program shows ambient + light · diffuse. */
function withShown(colors: Omit<MaterialColors, 'shown'>): MaterialColors {
  const { ambient, diffuse } = colors;
  const shown = (channel: 0 | 1 | 2): number => ambient[channel] + programLight * diffuse[channel];
  return { ...colors, shown: [shown(0), shown(1), shown(2)] };
}

function readColors(
  records: BinaryRecord,
  at: number,
  index: number,
  { colors, alphas }: MaterialFindings,
): MaterialColors {
  const offset = records.offset + at;
  const alpha = records.f32(at + 12);
  if (!(alpha >= 0 && alpha <= 1)) alphas.add(offset + 12, `${alpha}, material ${index}`);
  const power = records.f32(at + 16);
  const isPower = Math.abs(power) <= largestColor;
  if (!isPower) colors.add(offset + 16, `specular power ${power}, material ${index}`);
  return withShown({
    diffuse: color(0, fallback.diffuse),
    alpha: Number.isNaN(alpha) ? fallback.alpha : Math.min(Math.max(alpha, 0), 1),
    shininess: isPower ? Math.max(power, 0) : fallback.shininess,
    specular: color(20, fallback.specular),
    ambient: color(32, fallback.ambient),
  });

  function color(start: number, otherwise: Color): Color {
    const found = records.triple(at + start);
    if (found.every((value) => Math.abs(value) <= largestColor)) return found;
    colors.add(offset + start, `${found.join(' ')}, material ${index}`);
    return otherwise;
  }
}
