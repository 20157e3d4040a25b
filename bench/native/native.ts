import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Mesh } from '../../src/core/mesh.ts';
import type { Skin } from '../../src/core/skin.ts';
import { cacheFolder, findOnPath } from '../../tools/commands.mjs';
import type { Contender } from '../harness/measure.ts';

export interface NativeSkinning {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly contender: Contender;
}

const folder = path.join(cacheFolder, 'bench');
const runsPerSample = 20;

/** Compiles skin.cpp for this machine. Returns null if there is no compiler. */
export function nativeSkinning(
  id: string,
  mesh: Mesh,
  skin: Skin,
  palette: Float32Array,
): NativeSkinning | null {
  const compiler = findOnPath(['g++', 'clang++', 'c++']);
  if (compiler === undefined) return null;
  mkdirSync(folder, { recursive: true });
  const [program, input, output] = ['skin', 'skin-input', 'skin-output'].map((name) =>
    path.join(folder, name),
  ) as [string, string, string];
  const source = path.join(import.meta.dirname, 'skin.cpp');
  execFileSync(compiler, ['-O3', '-march=native', '-std=c++17', '-o', program, source]);
  writeFileSync(input, inputOf(mesh, skin, palette));
  const run = (count: number): number =>
    Number(execFileSync(program, [input, output, String(count)], { encoding: 'utf8' }));
  run(1);
  const { buffer, byteOffset, length } = readFileSync(output);
  const values = new Float32Array(buffer.slice(byteOffset, byteOffset + length));
  return {
    positions: values.subarray(0, mesh.vertexCount * 3),
    normals: values.subarray(mesh.vertexCount * 3),
    contender: { id, sample: () => ({ wall: run(runsPerSample) }) },
  };
}

/** The counts and arrays that skin.cpp reads, one after the other. */
function inputOf(mesh: Mesh, skin: Skin, palette: Float32Array): Uint8Array {
  const { positions, normals, vertexCount } = mesh;
  const { start, weights, entries, paletteJoint } = skin;
  const counts = Uint32Array.of(vertexCount, paletteJoint.length, weights.length);
  const arrays = [counts, positions, normals, palette, start, weights, entries];
  return Buffer.concat(
    arrays.map(({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength)),
  );
}
