import { unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { frameName, GrowingZip } from '../../../src/app/movie/growing-zip.ts';
import { openObjSequence } from '../../../src/app/movie/obj-sequence.ts';
import { createActor } from '../../../src/document/scene.ts';
import { Evaluator } from '../../../src/evaluation/evaluator.ts';
import { writeObj } from '../../../src/formats/obj/write-obj.ts';
import { readBundled } from '../../support/bundled.ts';
import { fullPool } from '../../support/kernels.ts';
import { planOf, sourceOf } from './fake-source.ts';

async function filesOf(zip: Blob): Promise<Record<string, Uint8Array>> {
  return unzipSync(new Uint8Array(await zip.arrayBuffer()));
}

it('an archive that grows holds every file as it was given', async () => {
  const zip = new GrowingZip();
  const files = Object.fromEntries(
    Array.from({ length: 12 }, (_, index) => {
      const bytes = Uint8Array.from({ length: 500_000 }, (_, at) => (at * (index + 1)) >> 3);
      return [frameName('frame', index, 12, '.bin'), bytes] as const;
    }),
  );
  for (const [at, [name, bytes]] of Object.entries(files).entries())
    zip.add(name, bytes, at % 2 === 0);
  const read = await filesOf(zip.finish());
  expect(Object.keys(read)).toEqual(Object.keys(files));
  for (const [name, bytes] of Object.entries(files)) {
    expect(Buffer.from(read[name]!).equals(bytes), name).toBe(true);
  }
});

it('names of frames are in their order', () => {
  expect(frameName('frame', 7, 60, '.png')).toBe('frame-0007.png');
  expect(frameName('mesh', 12_345, 20_000, '.obj')).toBe('mesh-12345.obj');
});

it('a sequence of meshes has the posed mesh of each frame', async () => {
  const character = await readBundled('insect');
  const actor = createActor(1, character, 'linear-blend', { clip: 0 });
  const plan = planOf({ format: 'obj', range: 'typed', from: 0, to: 0.4, rate: 10 });
  const posed = new Evaluator(actor, fullPool());
  const source = sourceOf(plan, () => [0, 0, 0, 0], posed);
  const sink = await openObjSequence(source);
  const expected: Uint8Array[] = [];
  for (let index = 0; index < plan.count; index++) {
    const { positions } = posed.evaluate(actor, index / 10).vertices();
    expected.push(writeObj(character.mesh, { positions, normals: null }));
    await sink.add(await source.frame(index));
  }
  const files = Object.values(await filesOf(await sink.finish()));
  expect(files).toHaveLength(4);
  for (const [index, file] of files.entries()) {
    expect(Buffer.from(file).equals(expected[index]!)).toBe(true);
  }
  expect(Buffer.from(files[0]!).equals(files[3]!)).toBe(false);
});

it('a sequence of meshes needs one', async () => {
  const plan = planOf({ format: 'obj' });
  const source = sourceOf(plan, () => [0, 0, 0, 0]);
  const sink = await openObjSequence(source);
  const frame = await source.frame(0);
  expect(() => sink.add(frame)).toThrow('no mesh');
});
