import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildCharacter } from '../../src/core/build-character.ts';
import { writeAnim } from '../../src/formats/cse169/write-anim.ts';
import { writeCse169 } from '../../src/formats/cse169/write-character.ts';
import { writeGzip } from './gzip-file.ts';
import { morphText } from './insect/morph-text.ts';
import { insectParts } from './insect/parts.ts';
import { paintTexture } from './insect/texture.ts';
import { insectWalk } from './insect/walk.ts';

/**
 * Makes the insect, which is Sinew's own: a wasp in the files of CSE169, with two morph targets, a
 * walk and a painted texture. In model units its body is about 1.8 long; +y is up, it faces +z, and
 * its feet are on y = 0.
 */
export function makeInsect(dataFolder: string): void {
  const { value: character, diagnostics } = buildCharacter(insectParts());
  if (!character || diagnostics.length > 0) throw new Error(JSON.stringify(diagnostics));
  const folder = join(dataFolder, 'insect');
  mkdirSync(folder, { recursive: true });
  const write = (name: string, content: string | Uint8Array): void => {
    const text = typeof content === 'string' ? content : new TextDecoder().decode(content);
    console.log(`${name}.gz: ${writeGzip(join(folder, `${name}.gz`), text)} bytes`);
  };
  for (const { path, bytes } of writeCse169(character).files) write(path, bytes);
  write('insect_breathe.morph', morphText({ breath: 1, alert: 0 }));
  write('insect_alert.morph', morphText({ breath: 0, alert: 1 }));
  write('insect_walk.anim', writeAnim(insectWalk()));
  const picture = paintTexture();
  writeFileSync(join(folder, 'insect.png'), picture);
  console.log(`insect.png: ${picture.length} bytes`);
}
