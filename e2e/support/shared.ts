import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import type { PoseJson } from '../../src/formats/pose-json.ts';
import type { NamedFile } from './app.ts';
import { test } from './test.ts';

/**
 * Real files and expected results, which some machines have beside the project; they are never part
 * of it.
 */
const shared = path.resolve(import.meta.dirname, '../../../shared');

const reference = 'reference/skinning/Model1';
const kinds = ['.skel', '.obj', '.attach'];
const kaitoReference = 'reference/pmd/KAITO';
const kaitoFiles = ['KAITO.pmd', 'eyeKT.bmp'];

export interface ReferencePose {
  readonly pose: PoseJson;
  /** (vertices × 3) by linear blending. */
  readonly vertices: Float32Array;
}

/** Skips the tests of a file with a message if Model1 and its references are missing. */
export function needModel1(): void {
  need([reference, ...kinds.map((kind) => `data/mit-6837/Model1${kind}`)]);
}

/** Like `needModel1`, for KAITO of the Virtual Mannequin. */
export function needKaito(): void {
  need([`${kaitoReference}.json`, ...kaitoFiles.map((name) => `data/pmd/${name}`)]);
}

function need(paths: readonly string[]): void {
  const absent = paths.find((each) => !existsSync(path.join(shared, each)));
  test.skip(absent !== undefined, `../shared/${absent ?? ''} is not there`);
}

/** Model1 of 6.837: `.skel`, `.obj`, `.attach`. */
export function model1Files(): NamedFile[] {
  return kinds.map((kind) => ({
    name: `Model1${kind}`,
    content: readFileSync(path.join(shared, `data/mit-6837/Model1${kind}`)),
  }));
}

export function model1Poses(): ReferencePose[] {
  const { poses } = JSON.parse(bytes(`${reference}/poses.json`).toString()) as {
    poses: {
      angles_xyz: [number, number, number][];
      root_translation: [number, number, number];
      files: { lbs: string };
    }[];
  };
  return poses.map(({ angles_xyz, root_translation, files }) => ({
    pose: {
      joints: Object.fromEntries(angles_xyz.map((angles, joint) => [`#${joint}`, angles])),
      root: root_translation,
    },
    vertices: floats(bytes(`${reference}/${files.lbs}`)),
  }));
}

/** The character and the image of its eyes. */
export function kaito(): NamedFile[] {
  return kaitoFiles.map((name) => ({ name, content: bytes(`data/pmd/${name}`) }));
}

/**
 * A reference pose in Sinew's right-handed space; the file's own space is its mirror image, with z
 * negated.
 */
export function kaitoPose(which: number): ReferencePose {
  const { poses } = JSON.parse(bytes(`${kaitoReference}.json`).toString()) as {
    poses: {
      angles_xyz: [number, number, number][];
      root_translation?: [number, number, number];
    }[];
  };
  const { angles_xyz, root_translation = [0, 0, 0] } = poses[which]!;
  const joints = angles_xyz.map(([x, y, z], joint) => [`#${joint}`, [-x, -y, z]] as const);
  const [x, y, z] = root_translation;
  const vertices = floats(bytes(`${kaitoReference}.pose${which}.lbs.f32`));
  return {
    pose: { joints: Object.fromEntries(joints) as PoseJson['joints'] & object, root: [x, y, -z] },
    vertices: vertices.map((value, i) => (i % 3 === 2 ? -value : value)),
  };
}

function bytes(name: string): Buffer {
  return readFileSync(path.join(shared, name));
}

/** Reads little-endian float32 on any machine. */
function floats(buffer: Buffer): Float32Array {
  return Float32Array.from({ length: buffer.length / 4 }, (_, i) => buffer.readFloatLE(i * 4));
}
