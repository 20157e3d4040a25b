import type { MeshParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { checkFloat32 } from '../text/check-float32.ts';
import { checkText } from '../text/check-text.ts';
import { growFloat32 } from '../text/growable.ts';
import { LineReader } from '../text/line-reader.ts';
import { FaceReader } from './face-reader.ts';

const effect = 'the mesh is not used';

/** Read over without a word: they group or shade faces, which changes nothing here. */
const silent = new Set(['g', 'o', 's']);

/**
 * Reads a Wavefront OBJ as found in the wild: `v` (with w or colour, unused), `vt`, `vn`, faces with
 * slashes, negative indices (counted back from their own line) and any number of corners,
 * `usemtl`, comments and continued lines. Vertices keep their order and number, used or not: the
 * rows of `.attach` count them. Material libraries are noted, never fetched.
 */
export function readObj(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
): Parsed<MeshParts> {
  const log = new DiagnosticLog(file);
  const text = checkText(bytes, log);
  if (!text) return log.finish<MeshParts>(undefined);
  const positions = growFloat32();
  const uvs = growFloat32();
  const normals = growFloat32();
  const reader = new LineReader(text, true);
  const faces = new FaceReader(reader, { positions, uvs, normals }, limits, log);
  const submeshes: { material: string; firstTriangle: number }[] = [];
  const noted = new Set<string>();

  while (reader.next()) {
    if (!reader.token()) continue;
    const keyword = reader.text();
    switch (keyword) {
      case 'v':
        readValues(positions, ['x', 'y', 'z']);
        break;
      case 'vt':
        readValues(uvs, ['u', 'v']);
        break;
      case 'vn':
        readValues(normals, ['x', 'y', 'z']);
        break;
      case 'f':
        faces.read();
        break;
      case 'usemtl':
        submeshes.push({ material: reader.rest(), firstTriangle: faces.triangleCount });
        break;
      default:
        if (!silent.has(keyword)) noteIgnored(keyword);
    }
    if (positions.length > limits.pointCount * 3) break;
  }
  checkCounts();
  if (submeshes[0]?.firstTriangle !== 0) submeshes.unshift({ material: '', firstTriangle: 0 });
  return log.finish({
    file,
    positions: positions.finish(),
    ...faces.finish(),
    ...(uvs.length > 0 ? { uvs: uvs.finish() } : {}),
    ...(normals.length > 0 ? { normals: normals.finish() } : {}),
    submeshes,
  });

  function readValues(target: typeof positions, names: readonly string[]): void {
    for (const [index, name] of names.entries()) {
      if (reader.token()) {
        target.push(checkFloat32(reader, name, 'obj', effect, log));
      } else if (name === 'v') {
        target.push(0); // a one-dimensional texture coordinate
      } else {
        const expected = `${names.length} numbers`;
        const found = `${index}`;
        log.error({ code: 'obj/field-count', ...reader.linePlace, expected, found, effect });
        target.push(NaN);
      }
    }
  }

  function noteIgnored(keyword: string): void {
    if (noted.has(keyword)) return;
    noted.add(keyword);
    const library = keyword === 'mtllib';
    log.warn({
      code: library || elements.has(keyword) ? 'obj/ignored' : 'obj/unknown',
      ...reader.place,
      expected: 'vertices, texture coordinates, normals and faces',
      found: library ? `mtllib ${reader.rest()}` : keyword,
      effect: library ? 'materials are not read; the surface is plain' : 'such lines are left out',
    });
  }

  function checkCounts(): void {
    if (positions.length > limits.pointCount * 3) {
      const expected = `at most ${limits.pointCount} vertices`;
      log.error({ code: 'obj/limit', expected, found: 'more', effect });
    } else if (positions.length === 0) {
      log.error({ code: 'obj/empty', expected: 'at least one vertex', found: 'none', effect });
    } else if (faces.triangleCount === 0 && !log.failed) {
      log.error({ code: 'obj/empty', expected: 'at least one triangle', found: 'none', effect });
    }
    if (faces.degenerateCount > 0) {
      log.warn({
        code: 'obj/degenerate',
        expected: 'triangles of three different vertices',
        found: `${faces.degenerateCount} that are not`,
        effect: 'they are left out',
      });
    }
  }
}

/** Elements that OBJ has besides faces. */
const elements = new Set(['l', 'p', 'curv', 'curv2', 'surf', 'mtllib', 'vp', 'cstype', 'deg']);
