import type { DiagnosticLog } from '../../core/diagnostics.ts';
import type { Limits } from '../../core/limits.ts';
import type { BinaryReader, RecordArray } from '../binary/binary-reader.ts';
import { boundText } from '../text/bound-text.ts';
import { Findings } from './findings.ts';
import { mirrored } from './mirror.ts';

/** The vertices of a PMD, right-handed, one normal and one texture coordinate each. */
export interface PmdVertices {
  readonly count: number;
  /** Offset of the first record in the file, and the size of a record, for messages. */
  readonly offset: number;
  /** (count × 3) model units. */
  readonly positions: Float32Array;
  /** (count × 3) usually unit; zero if the file's normal can't be used. */
  readonly normals: Float32Array;
  /** (count × 2) v counts downwards, as in the file. */
  readonly uvs: Float32Array;
  /** (count × 2) */
  readonly bones: Uint16Array;
  /** (count) hundredths of the first bone. */
  readonly weights: Uint8Array;
  /** (count) 1 if no outline is drawn. */
  readonly edgeFlags: Uint8Array;
}

export const vertexSize = 38;

/** Where the fields of a record are. */
const normalAt = 12;
const uvAt = 24;
const boneAt = 32;
const weightAt = 36;
const edgeAt = 37;

/** Reads `count × (position, normal, uv, bone, bone, weight, edge flag)`. */
export function readVertices(
  reader: BinaryReader,
  log: DiagnosticLog,
  limits: Limits,
  effect: string,
): PmdVertices | undefined {
  const array = reader.array(4, vertexSize, 'vertices');
  if (!array) return undefined;
  if (array.count > limits.pointCount) {
    const expected = `at most ${limits.pointCount} vertices`;
    log.error({
      code: 'pmd/limit',
      offset: array.offset,
      expected,
      found: `${array.count}`,
      effect,
    });
    return undefined;
  }
  return fill(array, log, limits.coordinate, effect);
}

function fill(
  { count, records }: RecordArray,
  log: DiagnosticLog,
  largest: number,
  effect: string,
): PmdVertices {
  const vertices: PmdVertices = {
    count,
    offset: records.offset,
    positions: new Float32Array(count * 3),
    normals: new Float32Array(count * 3),
    uvs: new Float32Array(count * 2),
    bones: new Uint16Array(count * 2),
    weights: new Uint8Array(count),
    edgeFlags: new Uint8Array(count),
  };
  const odd = { normals: new Findings(), uvs: new Findings() };
  const past = { weights: new Findings(), edges: new Findings() };
  const { positions, normals, uvs, bones, weights, edgeFlags } = vertices;
  // Nothing is allocated for a sound vertex.
  for (let vertex = 0; vertex < count; vertex++) {
    const at = vertex * vertexSize;
    const offset = records.offset + at;
    const px = records.f32(at);
    const py = records.f32(at + 4);
    const pz = records.f32(at + 8);
    if (!(isWithin(px, largest) && isWithin(py, largest) && isWithin(pz, largest))) {
      [px, py, pz].forEach((value, axis) => checkCoordinate(value, offset + axis * 4, vertex));
    }
    positions[vertex * 3] = px;
    positions[vertex * 3 + 1] = py;
    positions[vertex * 3 + 2] = mirrored(pz);
    const x = records.f32(at + normalAt);
    const y = records.f32(at + normalAt + 4);
    const z = records.f32(at + normalAt + 8);
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 1e-12 && length <= largest) {
      normals[vertex * 3] = x;
      normals[vertex * 3 + 1] = y;
      normals[vertex * 3 + 2] = mirrored(z);
    } else odd.normals.add(offset + normalAt, `${x} ${y} ${z}, vertex ${vertex}`);
    const u = records.f32(at + uvAt);
    const v = records.f32(at + uvAt + 4);
    if (isWithin(u, largest) && isWithin(v, largest)) {
      uvs[vertex * 2] = u;
      uvs[vertex * 2 + 1] = v;
    } else odd.uvs.add(offset + uvAt, `${u} ${v}, vertex ${vertex}`);
    bones[vertex * 2] = records.u16(at + boneAt);
    bones[vertex * 2 + 1] = records.u16(at + boneAt + 2);
    const weight = records.u8(at + weightAt);
    if (weight > 100) past.weights.add(offset + weightAt, `${weight}, vertex ${vertex}`);
    weights[vertex] = Math.min(weight, 100);
    const edge = records.u8(at + edgeAt);
    if (edge > 1) past.edges.add(offset + edgeAt, `${edge}, vertex ${vertex}`);
    edgeFlags[vertex] = Math.min(edge, 1);
  }
  const computed = 'they are computed from the triangles';
  odd.normals.warn(log, 'pmd/normal', 'normals with a length', computed);
  odd.uvs.warn(log, 'pmd/uv', 'texture coordinates that are numbers', '0 0 is used');
  past.weights.warn(log, 'pmd/range', 'weights from 0 to 100', '100 is used');
  past.edges.warn(log, 'pmd/range', 'edge flags of 0 or 1', '1 is used');
  return vertices;

  function checkCoordinate(value: number, offset: number, vertex: number): void {
    if (Math.abs(value) <= largest) return;
    const found = `${value}, vertex ${vertex}`;
    if (Number.isFinite(value)) {
      const expected = `a position within ±${boundText(largest)}`;
      log.error({ code: 'pmd/range', offset, expected, found, effect });
    } else log.error({ code: 'pmd/number', offset, expected: 'a position', found, effect });
  }
}

function isWithin(value: number, largest: number): boolean {
  return value <= largest && value >= -largest;
}
