import { vec3 } from 'gl-matrix';
import type { Camera } from '../../document/camera.ts';
import type { Evaluation } from '../../evaluation/evaluation.ts';
import { insertPngText } from '../../formats/png/text-chunk.ts';
import { type PngPixels, writePng } from '../../formats/png/write-png.ts';
import { axesOf, nearOf } from '../camera.ts';
import type { Viewer } from '../viewer.ts';
import { drawGeometry } from './geometry.ts';
import { drawApart } from './held-moment.ts';
import { eachTile, type PictureRequest, type PictureWork, windowOf } from './make-picture.ts';
import { checkPictureSize } from './picture-tiles.ts';
import { type SeenPoint, SurfaceReader } from './surface-reader.ts';

export type PassImageId = 'depth' | 'normal' | 'joint' | 'mask';

export const passImages: readonly PassImageId[] = ['depth', 'normal', 'joint', 'mask'];

/** What a pass writes for each pixel that shows a character. Other pixels are 0. */
interface PassImage {
  readonly kind: PngPixels['kind'];
  /** What the numbers mean, which the file says too. */
  readonly note: string;
  write(point: SeenPoint, bytes: Uint8Array, at: number): void;
}

/** So many samples on a side are read before the page gets a turn. */
const tileSide = 1024;
const [darkest, brightest] = [1, 65_535];

/**
 * Makes pictures of data from the camera of a picture, each as the bytes of a PNG: the middle of each
 * pixel without anti-aliasing, since a mean of depths or of joints is neither.
 */
export async function makePasses(
  viewer: Viewer,
  ids: readonly PassImageId[],
  { size, contents, tileLimit = tileSide }: Omit<PictureRequest, 'samples' | 'showSurroundings'>,
  work: PictureWork = {},
): Promise<ReadonlyMap<PassImageId, Uint8Array>> {
  checkPictureSize(size);
  const { width, height } = size;
  const goals = new Map<PassImageId, Uint8Array>();
  const notes = new Map<PassImageId, string>();
  for (const id of ids) goals.set(id, new Uint8Array(width * height * (id === 'depth' ? 2 : 3)));
  await eachTile(viewer, { size, contents, samples: 1, tileLimit }, work, (part) => {
    const { content, held, view, tile } = part;
    const { camera, overrides, clip = view } = content;
    const drawn = {
      ...{ camera, overrides },
      viewport: { x: 0, y: 0, width: tile.width, height: tile.height },
      window: windowOf(view, tile, 1),
    };
    const { geometry, shown } = drawApart(viewer, drawn, held.shown, {}, (renderer, frame) => ({
      geometry: drawGeometry(renderer, frame),
      shown: frame.characters.map(({ evaluation }) => evaluation),
    }));
    const reader = new SurfaceReader(shown, content.camera);
    const images = ids.map((id) => {
      const image = passImage(id, content.camera, shown);
      notes.set(id, image.note);
      return { ...image, bytes: goals.get(id)!, pixelBytes: image.kind === 'gray16' ? 2 : 3 };
    });
    for (let row = 0; row < tile.height; row++) {
      const top = height - 1 - tile.y - row;
      for (let column = 0; column < tile.width; column++) {
        const x = view.x + tile.x + column;
        if (x < clip.x || x >= clip.x + clip.width) continue;
        const point = reader.at(geometry, (row * tile.width + column) * 4);
        if (!point) continue;
        const at = top * width + x;
        for (const image of images) image.write(point, image.bytes, at * image.pixelBytes);
      }
    }
  });
  return new Map(
    ids.map((id) => {
      const kind = id === 'depth' ? 'gray16' : 'rgb8';
      const png = writePng({ width, height, kind, bytes: goals.get(id)! });
      return [id, insertPngText(png, 'Description', notes.get(id) ?? id)];
    }),
  );
}

function passImage(id: PassImageId, camera: Camera, shown: readonly Evaluation[]): PassImage {
  switch (id) {
    case 'depth':
      return depthImage(camera, shown);
    case 'normal':
      return {
        kind: 'rgb8',
        note: 'Normals in camera space (x right, y up, z to the viewer): 255 * (0.5 + 0.5 n); black is none',
        write: ({ normal }, bytes, at) => {
          for (let i = 0; i < 3; i++) bytes[at + i] = Math.round(255 * (0.5 + 0.5 * normal[i]!));
        },
      };
    case 'joint':
      return {
        kind: 'rgb8',
        note: 'The color of the joint with the largest weight; black is none',
        write: ({ joint }, bytes, at) => bytes.set(joint === null ? gray : colorOf(joint), at),
      };
    case 'mask':
      return {
        kind: 'rgb8',
        note: 'A color for each character, the first one white; black is none',
        write: ({ character }, bytes, at) =>
          bytes.set(character === 0 ? white : colorOf(character - 1), at),
      };
  }
}

/** Depth along the camera's line of sight, from black at the nearest vertex to white at the farthest. */
function depthImage(camera: Camera, shown: readonly Evaluation[]): PassImage {
  const [near, far] = depthRange(camera, shown);
  const factor = far > near ? (brightest - darkest) / (far - near) : 0;
  return {
    kind: 'gray16',
    note:
      `Depth in scene units along the line of sight: ${near} + (value - ${darkest}) / ` +
      `${brightest - darkest} * ${far - near}; 0 is nothing`,
    write: ({ depth }, bytes, at) => {
      const value = darkest + Math.round(Math.min(Math.max(depth - near, 0), far - near) * factor);
      bytes[at] = value >> 8;
      bytes[at + 1] = value & 255;
    },
  };
}

/** The least and the largest depth of the characters' vertices that are in front of the camera. */
function depthRange(camera: Camera, shown: readonly Evaluation[]): readonly [number, number] {
  const { look } = axesOf(camera);
  const point: vec3 = new Float64Array(3);
  let [near, far] = [Infinity, -Infinity];
  for (const evaluation of shown) {
    const { positions } = evaluation.vertices();
    for (let at = 0; at < positions.length; at += 3) {
      vec3.set(point, positions[at]!, positions[at + 1]!, positions[at + 2]!);
      vec3.transformMat4(point, point, evaluation.display.sceneFromCharacter);
      vec3.subtract(point, point, camera.target);
      const depth = vec3.dot(point, look) + camera.distance;
      near = Math.min(near, depth);
      far = Math.max(far, depth);
    }
  }
  if (far < near) return [0, 0];
  if (camera.projection === 'orthographic') return [near, far];
  const cut = nearOf(camera);
  return [Math.max(near, cut), Math.max(far, cut)];
}

const white = [255, 255, 255];
const gray = [96, 96, 96];

/** Colors that differ from each other: hues that are the golden angle apart, in three lightnesses. */
function colorOf(index: number): readonly number[] {
  const hue = (index * 137.508) % 360;
  const level = [0.55, 0.75, 0.38][index % 3]!;
  return [0, 8, 4].map((n) => {
    const k = (n + hue / 30) % 12;
    const chroma = 0.9 * Math.min(level, 1 - level);
    return Math.round(255 * (level - chroma * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  });
}
