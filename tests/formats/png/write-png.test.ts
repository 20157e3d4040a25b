import fc from 'fast-check';
import { PNG } from 'pngjs';
import { expect, it } from 'vitest';
import { writePng } from '../../../src/formats/png/write-png.ts';

const sides = fc.integer({ min: 1, max: 9 });

it('another program reads 16 bits of gray as they were written', () => {
  fc.assert(
    fc.property(sides, sides, fc.infiniteStream(fc.nat(0xffff)), (width, height, values) => {
      const numbers = Array.from({ length: width * height }, () => values.next().value as number);
      const bytes = Uint8Array.from(numbers.flatMap((value) => [value >> 8, value & 255]));
      const png = writePng({ width, height, kind: 'gray16', bytes });
      const read = PNG.sync.read(Buffer.from(png), { skipRescale: true });
      expect([read.width, read.height]).toEqual([width, height]);
      expect(numbers.map((_, at) => read.data[at * 4])).toEqual(numbers);
    }),
    { numRuns: 50 },
  );
});

it('another program reads 8 bits of red, green and blue as they were written', () => {
  fc.assert(
    fc.property(sides, sides, fc.infiniteStream(fc.nat(255)), (width, height, values) => {
      const bytes = Uint8Array.from(
        { length: width * height * 3 },
        () => values.next().value as number,
      );
      const png = writePng({ width, height, kind: 'rgb8', bytes });
      const { data } = PNG.sync.read(Buffer.from(png));
      const read = [...data].filter((_, at) => at % 4 < 3);
      expect(read).toEqual([...bytes]);
    }),
    { numRuns: 50 },
  );
});
