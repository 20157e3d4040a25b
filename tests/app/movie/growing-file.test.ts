import fc from 'fast-check';
import { expect, it } from 'vitest';
import { GrowingFile } from '../../../src/app/movie/growing-file.ts';

it('has the bytes that were written last at each place', async () => {
  const writes = fc.array(
    fc.record({ position: fc.nat(40), data: fc.uint8Array({ maxLength: 12 }) }),
    { maxLength: 12 },
  );
  await fc.assert(
    fc.asyncProperty(writes, async (all) => {
      const file = new GrowingFile();
      const expected: number[] = [];
      for (const { position, data } of all) {
        file.write({ position, data: new Uint8Array(data) });
        while (expected.length < position) expected.push(0);
        expected.splice(position, data.length, ...data);
      }
      const blob = file.finish('video/webm');
      expect(blob.type).toBe('video/webm');
      expect([...new Uint8Array(await blob.arrayBuffer())]).toEqual(expected);
    }),
  );
});

it('keeps large parts in order', async () => {
  const file = new GrowingFile();
  const size = 3_000_000;
  for (const value of [1, 2, 3]) {
    file.write({ position: (value - 1) * size, data: new Uint8Array(size).fill(value) });
  }
  file.write({ position: 5, data: Uint8Array.of(9) });
  const bytes = new Uint8Array(await file.finish('video/webm').arrayBuffer());
  expect([bytes.length, bytes[4], bytes[5], bytes[size], bytes[3 * size - 1]]).toEqual([
    ...[3 * size, 1, 9, 2, 3],
  ]);
});
