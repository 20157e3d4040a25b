import { readFileSync } from 'node:fs';
import type { SourceBone, SourceSkin } from './source-skin.ts';
import { add, type Vector2, type Vector3 } from './vector.ts';

const NAME_BYTES = 40;

/**
 * Reads MuJoCo's binary skin: four counts (vertices, texture coordinates, faces, bones), then
 * positions, texture coordinates, faces, and for each bone its name, bind position, bind
 * orientation, number of vertices, their indices and their weights. All numbers are little-endian
 * int32 or float32. MuJoCo counts v from the top of the picture.
 *
 * @param name for its only part
 */
export function readMujocoSkin(path: string, name: string): SourceSkin {
  const file = readFileSync(path);
  let at = 0;
  const integer = (): number => file.readInt32LE((at += 4) - 4);
  const float = (): number => file.readFloatLE((at += 4) - 4);
  const repeat = <Item>(count: number, read: () => Item): Item[] =>
    Array.from({ length: count }, read);
  const point = (): Vector3 => [float(), float(), float()];

  const [vertexCount, textureCount, faceCount, boneCount] = [
    integer(),
    integer(),
    integer(),
    integer(),
  ];
  if (textureCount !== vertexCount) throw new Error(`${path}: not one texture coordinate a vertex`);
  const positions = repeat(vertexCount, point);
  const textureCoordinates = repeat(textureCount, (): Vector2 => [float(), 1 - float()]);
  const triangles = repeat(faceCount, () => [integer(), integer(), integer()]);
  const bones = new Map<string, SourceBone>();
  for (let bone = 0; bone < boneCount; bone++) {
    const bytes = file.subarray(at, at + NAME_BYTES);
    const boneName = bytes.toString('utf8', 0, bytes.indexOf(0));
    at += NAME_BYTES;
    const position = point();
    const [w, ...xyz] = repeat(4, float);
    if (w !== 1 || xyz.some((part) => part !== 0)) throw new Error(`${boneName} is bound turned`);
    const count = integer();
    const vertices = repeat(count, integer);
    const weights = vertices.map((vertex): [number, number] => [vertex, float()]);
    bones.set(boneName, { position, weights: new Map(weights) });
  }
  return { positions, textureCoordinates, parts: [{ name, triangles }], bones };
}

/** Reads a tag's attributes from the text after its name. */
function attributesOf(text: string): ReadonlyMap<string, string> {
  return new Map([...text.matchAll(/(\w+)="([^"]*)"/g)].map(([, key, value]) => [key!, value!]));
}

function parsePoint(text: string): Vector3 {
  const [x = NaN, y = NaN, z = NaN] = text.trim().split(/\s+/).map(Number);
  if ([x, y, z].some(Number.isNaN)) throw new Error(`not a point: ${text}`);
  return [x, y, z];
}

/**
 * For each body of a MuJoCo model, returns the position of its last joint relative to the body's
 * own origin. Bodies without a joint are absent. A joint without a `pos` has that of its default
 * class, and a class without one has that of the enclosing class.
 */
export function readJointPlaces(path: string): ReadonlyMap<string, Vector3> {
  const places = new Map<string, Vector3>();
  const classPlaces = new Map<string, string>();
  const classes: string[] = [];
  const bodies: string[] = [];
  const tags = readFileSync(path, 'utf8').matchAll(/<(\/?)(default|body|joint)\b([^>]*)>/g);
  for (const [, slash, tag, text] of tags) {
    const attributes = attributesOf(text!);
    const place = attributes.get('pos');
    const className = attributes.get('class') ?? 'main';
    const currentClass = classes.at(-1);
    const currentBody = bodies.at(-1);
    if (tag === 'joint' && currentClass !== undefined) {
      if (place !== undefined) classPlaces.set(currentClass, place);
    } else if (tag === 'joint' && currentBody !== undefined) {
      places.set(currentBody, parsePoint(place ?? classPlaces.get(className) ?? '0 0 0'));
    } else if (tag === 'body') {
      if (slash === '') bodies.push(attributes.get('name') ?? '');
      else bodies.pop();
    } else if (tag === 'default') {
      if (slash === '') {
        classes.push(className);
        classPlaces.set(className, classPlaces.get(currentClass ?? '') ?? '0 0 0');
      } else {
        classes.pop();
      }
    }
  }
  return places;
}

/** Moves the skin's bones to the positions of the model's joints. */
export function moveBones(skin: SourceSkin, places: ReadonlyMap<string, Vector3>): SourceSkin {
  const bones = [...skin.bones].map(([name, bone]): [string, SourceBone] => {
    const place = places.get(name);
    return [name, place ? { ...bone, position: add(bone.position, place) } : bone];
  });
  return { ...skin, bones: new Map(bones) };
}
