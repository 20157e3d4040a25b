import type { MeshParts } from '../../core/character-parts.ts';
import { DiagnosticLog, type Parsed } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { defaultLimits, type Limits } from '../../core/limits.ts';
import { openText } from '../text/open-text.ts';
import type { CarefulLines } from './careful-lines.ts';
import { continued } from './continued.ts';
import { FaceList } from './face-list.ts';
import { PlainLines } from './plain-lines.ts';
import { triangulateFaces } from './triangulate-faces.ts';
import { type ObjStreams, TupleStream } from './tuple-stream.ts';

const effect = 'the mesh is not used';

/** Ignored without a message: they group or shade faces, which has no effect here. */
const silent = new Set(['g', 'o', 's']);

/** About as many bytes as files have for each coordinate and for each corner, rather fewer. */
const bytesPerCoordinate = 16;
const bytesPerCorner = 10;

/**
 * Reads a Wavefront OBJ: `v` (with w or color, unused), `vt`, `vn`, faces with slashes, negative
 * indices (counted back from their own line) and any number of corners, `usemtl`, comments and
 * continued lines. Vertices keep their order and number, whether used or not, because the rows of
 * `.attach` count them. Most lines are plain, so what reads the others is loaded when it is needed.
 *
 * @param hasLibrary whether a material library is read with it; otherwise `mtllib` is reported
 */
export async function readObj(
  file: string,
  bytes: Uint8Array,
  limits: Limits = defaultLimits,
  hasLibrary = false,
): Promise<Parsed<MeshParts>> {
  const log = new DiagnosticLog(file);
  const reader = openText(file, bytes, log, { limits, continued });
  if (!reader) return log.finish<MeshParts>(undefined);
  const streams: ObjStreams = {
    positions: new TupleStream(
      {
        what: 'vertices',
        sparedBy: 'triangles',
        names: ['x', 'y', 'z'],
        most: limits.pointCount,
        largest: limits.coordinate,
      },
      Math.ceil(bytes.length / bytesPerCoordinate),
    ),
    uvs: new TupleStream({
      what: 'texture coordinates',
      sparedBy: 'corners',
      names: ['u', 'v'],
      fewest: 1, // texture coordinates may be one-dimensional
      most: limits.triangleCount * 3,
    }),
    normals: new TupleStream({
      what: 'normals',
      sparedBy: 'corners',
      names: ['x', 'y', 'z'],
      most: limits.triangleCount * 3,
    }),
  };
  const faces = new FaceList(limits.triangleCount, Math.ceil(bytes.length / bytesPerCorner));
  const plainLines = new PlainLines(reader, streams, faces);
  const runs: { material: string; firstFace: number }[] = [];
  let careful: CarefulLines | undefined;
  const loadCareful = async (): Promise<CarefulLines> => {
    const { CarefulLines } = await loadPart(import('./careful-lines.ts'));
    return new CarefulLines(reader, streams, faces, log);
  };

  while (!careful?.isFull) {
    plainLines.read();
    if (!reader.next()) break;
    if (!reader.token()) continue;
    const keyword = reader.text();
    if (keyword === 'usemtl') runs.push({ material: reader.rest(), firstFace: faces.count });
    else if (!silent.has(keyword) && !(hasLibrary && keyword === 'mtllib'))
      (careful ??= await loadCareful()).read(keyword);
  }
  const positions = streams.positions.finish();
  const { corners, firstTriangles, degenerateCount } = await triangulateFaces(
    faces.finish(),
    positions,
    runs.map(({ firstFace }) => firstFace),
  );
  if (!log.failed) checkCounts(positions, corners.cornerPoints, log);
  if (degenerateCount > 0) careful ??= await loadCareful();
  careful?.reportOddities(degenerateCount);
  const submeshes = runs
    .map(({ material }, index) => ({ material, firstTriangle: firstTriangles[index]! }))
    // Of consecutive ones without a triangle between them, the last one counts.
    .filter((run, index, all) => run.firstTriangle !== all[index + 1]?.firstTriangle);
  if (submeshes[0]?.firstTriangle !== 0) submeshes.unshift({ material: '', firstTriangle: 0 });
  const [uvs, normals] = [streams.uvs.finish(), streams.normals.finish()];
  return log.finish({
    file,
    positions,
    ...corners,
    ...(uvs.length > 0 ? { uvs } : {}),
    ...(normals.length > 0 ? { normals } : {}),
    submeshes,
  });
}

function checkCounts(positions: Float32Array, cornerPoints: Uint32Array, log: DiagnosticLog): void {
  const missing = positions.length === 0 ? 'vertex' : 'triangle';
  if (positions.length > 0 && cornerPoints.length > 0) return;
  log.error({ code: 'obj/empty', expected: `at least one ${missing}`, found: 'none', effect });
}
