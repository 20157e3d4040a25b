import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import type { Character } from '../../../src/core/character.ts';
import { jointMatrices } from '../../../src/core/forward-kinematics.ts';
import { memoryFile } from '../../../src/formats/file-entry.ts';
import { readCharacters } from '../../../src/formats/read-characters.ts';
import { add, dot, meanOf, scale, unit, type Vector3 } from '../vector.ts';

/** Goals look at so many points of a region at most, spread over it. */
const MOST_POINTS = 200;

/** Some points of the skin, which goals are about. */
export type Region = readonly number[];

/** A bundled character whose pose is being solved. All lengths are in meters. */
export class Figure {
  readonly character: Character;
  /** (pointCount) the joint that each point follows most. */
  private readonly leaders: Uint16Array;

  constructor(character: Character) {
    this.character = character;
    const { start, entries, weights, paletteJoint } = character.skin;
    this.leaders = Uint16Array.from({ length: character.mesh.pointCount }, (_, point) => {
      const row = weights.subarray(start[point], start[point + 1]);
      return paletteJoint[entries[start[point]! + row.indexOf(Math.max(...row))]!]!;
    });
  }

  joint(name: string): number {
    const joint = this.character.skeleton.names.indexOf(name);
    if (joint < 0) throw new Error(`${this.character.name} has no joint ${name}`);
    return joint;
  }

  /**
   * The points that follow some joints most; with a direction, only those whose skin faces it at
   * rest.
   */
  region(joints: readonly string[], facing?: Vector3): Region {
    const wanted = new Set(joints.map((name) => this.joint(name)));
    const { pointOf, normals, vertexCount } = this.character.mesh;
    const found = new Set<number>();
    for (let vertex = 0; vertex < vertexCount; vertex++) {
      const point = pointOf[vertex]!;
      if (!wanted.has(this.leaders[point]!)) continue;
      const [x, y, z] = [0, 1, 2].map((axis) => normals[vertex * 3 + axis]!);
      if (facing === undefined || dot([x!, y!, z!], unit(facing)) > 0.6) found.add(point);
    }
    const points = [...found];
    return points.filter((_, index) => index % Math.ceil(points.length / MOST_POINTS) === 0);
  }

  posed(q: Float64Array): Posed {
    return new Posed(this, q);
  }
}

/** A figure in a pose. */
export class Posed {
  private readonly figure: Figure;
  private readonly characterFromJoint: Float64Array;

  constructor(figure: Figure, q: Float64Array) {
    this.figure = figure;
    this.characterFromJoint = jointMatrices(figure.character.skeleton, q);
  }

  place(joint: string): Vector3 {
    return transform(this.characterFromJoint, this.figure.joint(joint) * 16, [0, 0, 0], 1);
  }

  /** Where a direction of the rest pose points after it has turned with a joint. */
  direction(joint: string, atRest: Vector3): Vector3 {
    return transform(this.characterFromJoint, this.figure.joint(joint) * 16, unit(atRest), 0);
  }

  /** A point of the skin, by linear blending; joints are bound unturned. */
  point(point: number): Vector3 {
    const { skin, mesh } = this.figure.character;
    const [x, y, z] = mesh.positions.subarray(point * 3, point * 3 + 3);
    let sum: Vector3 = [0, 0, 0];
    for (let i = skin.start[point]!; i < skin.start[point + 1]!; i++) {
      const entry = skin.entries[i]!;
      const local = transform(skin.jointFromBind, entry * 16, [x!, y!, z!], 1);
      const moved = transform(this.characterFromJoint, skin.paletteJoint[entry]! * 16, local, 1);
      sum = add(sum, scale(moved, skin.weights[i]!));
    }
    return sum;
  }

  middle(region: Region): Vector3 {
    return meanOf(region.map((point) => this.point(point)));
  }

  /** The height of the lowest point. */
  bottom(region: Region): number {
    return region.reduce((low, point) => Math.min(low, this.point(point)[1]), Infinity);
  }
}

function transform(matrices: Float64Array, at: number, [x, y, z]: Vector3, w: 0 | 1): Vector3 {
  const row = (axis: number): number =>
    matrices[at + axis]! * x +
    matrices[at + 4 + axis]! * y +
    matrices[at + 8 + axis]! * z +
    matrices[at + 12 + axis]! * w;
  return [row(0), row(1), row(2)];
}

/** Reads a bundled character from its gzipped files. */
export async function readFigure(dataFolder: string, id: string): Promise<Figure> {
  const folder = join(dataFolder, id);
  const files = readdirSync(folder)
    .filter((name) => name.endsWith('.gz'))
    .map((name) =>
      memoryFile(name.replace(/\.gz$/, ''), gunzipSync(readFileSync(join(folder, name)))),
    );
  const { characters } = await readCharacters(files);
  return new Figure(characters[0]!.character);
}
