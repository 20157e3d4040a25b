import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import type { Character } from '../../src/core/character.ts';
import { convertCharacter } from '../../src/formats/convert.ts';
import { memoryFile } from '../../src/formats/file-entry.ts';
import { readCharacters } from '../../src/formats/read-characters.ts';
import { readPoseJson } from '../../src/formats/read-pose-json.ts';
import { loadWriter } from '../../src/formats/registry.ts';
import { poseToJson } from '../../src/formats/write-pose-json.ts';
import { writeGzip } from './gzip-file.ts';

/** Half of the way from the middle to the hip joints, in meters. */
const hipOffset = 0.05;

/**
 * Makes the mannequin from the files of the human: a PMD with its shape, its materials and its pose.
 * A PMD's bones need a length, but the human's root, hips and the begins of both legs are at one
 * point. The mannequin's root is on the floor, and its hips are apart.
 */
export async function makeMannequin(dataFolder: string): Promise<void> {
  const human = await readHuman(join(dataFolder, 'human'));
  const text = readFileSync(join(dataFolder, 'human/human.pose.json'), 'utf8');
  const pose = readPoseJson('human.pose.json', text, human.skeleton).value!;
  const converted = convertCharacter(human, 'mmd', pose);
  const { files } = (await loadWriter('mmd'))(converted.character);
  writeGzip(join(dataFolder, 'mannequin/mannequin.pmd.gz'), files[0]!.bytes);
  const json = poseToJson(converted.character.skeleton, converted.pose);
  writeFileSync(
    join(dataFolder, 'mannequin/mannequin.pose.json'),
    `${JSON.stringify(json, (_, value: unknown) => (typeof value === 'number' ? Number(value.toFixed(5)) : value), 2)}\n`,
  );
}

async function readHuman(folder: string): Promise<Character> {
  const files = ['skel', 'obj', 'mtl', 'attach'].map((kind) => {
    const bytes = gunzipSync(readFileSync(join(folder, `human.${kind}.gz`)));
    return memoryFile(`mannequin.${kind}`, kind === 'skel' ? spread(bytes) : bytes);
  });
  const { characters } = await readCharacters(files);
  return characters[0]!.character;
}

/** Moves the root to the floor, and the joints of the hips apart; every other joint stays. */
function spread(skel: Uint8Array): Uint8Array {
  const rows = new TextDecoder()
    .decode(skel)
    .trim()
    .split('\n')
    .map((line) => line.split(' ').map(Number) as [number, number, number, number]);
  const height = rows[0]![1];
  rows[0]![1] = 0;
  rows.forEach((row, joint) => {
    const [x, y, z, parent] = row;
    if (joint === 0 || x !== 0 || y !== 0 || z !== 0) return;
    if (parent === 0) {
      row[1] = height;
      return;
    }
    const child = rows.find((each) => each[3] === joint)!;
    row[0] = Math.sign(child[0]) * hipOffset;
    child[0] -= row[0];
  });
  return new TextEncoder().encode(rows.map((row) => `${row.join(' ')}\n`).join(''));
}
