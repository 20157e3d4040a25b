import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { expect, test } from '@playwright/test';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

const folder = path.resolve(import.meta.dirname, '../expected');
/** UPDATE_PICTURES=1 overwrites the expected pictures with the actual ones; look at each. */
const isUpdating = Boolean(process.env['UPDATE_PICTURES']);

/**
 * The difference of a pixel's color that counts, and the share of all pixels that may differ so:
 * this finds what is drawn in another place.
 */
const [colorThreshold, pixelShare] = [0.1, 0.001];
/**
 * The mean difference of a byte: this finds small changes of the light everywhere. One renderer
 * draws all pictures.
 */
const meanThreshold = 0.2;
/** An empty picture has fewer colors; the floor and the background have some hundreds. */
const fewestColors = 500;

/**
 * Compares a picture with `expected/NAME.png`. If they differ, both are kept in the test's folder.
 */
export function expectPicture(name: string, bytes: Buffer): void {
  const actual = PNG.sync.read(bytes);
  expect(colorCount(actual), 'colors, since the view may be empty').toBeGreaterThan(fewestColors);
  const file = path.join(folder, `${name}.png`);
  if (isUpdating) {
    mkdirSync(folder, { recursive: true });
    writeFileSync(file, bytes);
    return;
  }
  const keep = (kind: string, content: Buffer): Promise<void> => {
    const kept = test.info().outputPath(`${name}-${kind}.png`);
    writeFileSync(kept, content);
    return test.info().attach(kind, { path: kept });
  };
  if (!existsSync(file)) {
    void keep('actual', bytes);
    throw new Error(`e2e/expected/${name}.png is not there; UPDATE_PICTURES=1 writes it`);
  }
  const expected = PNG.sync.read(readFileSync(file));
  const { width, height } = expected;
  expect({ width: actual.width, height: actual.height }).toEqual({ width, height });
  const difference = new PNG({ width, height });
  const count = pixelmatch(actual.data, expected.data, difference.data, width, height, {
    threshold: colorThreshold,
  });
  const change = meanDifference(actual.data, expected.data);
  if (count <= pixelShare * width * height && change <= meanThreshold) return;
  void keep('actual', bytes);
  void keep('difference', PNG.sync.write(difference));
  throw new Error(
    `${count} pixels differ from e2e/expected/${name}.png, and bytes by ${change.toFixed(3)} in the mean`,
  );
}

function meanDifference(a: Buffer, b: Buffer): number {
  return a.reduce((sum, byte, i) => sum + Math.abs(byte - b[i]!), 0) / a.length;
}

function colorCount({ data }: PNG): number {
  return new Set(new Uint32Array(data.buffer, data.byteOffset, data.length / 4)).size;
}
