import { expect, it } from 'vitest';
import type { CharacterImage } from '../../../src/core/character.ts';
import { DecodedImages, type Picture } from '../../../src/view/dress/decoded-images.ts';

const imageOf = (name: string): CharacterImage => ({
  name,
  textures: [],
  bytes: new Uint8Array(0),
});

/** Images of a thousand bytes each; the decodings are counted. */
function setUp(byteLimit: number) {
  const decoded: string[] = [];
  const decode = ({ name }: CharacterImage): Promise<Picture | string> => {
    decoded.push(name);
    return Promise.resolve(
      name === 'broken' ? 'no picture' : ({ width: 25, height: 10 } as Picture),
    );
  };
  return { decoded, images: new DecodedImages(decode, byteLimit) };
}

it('keeps decoded images, so that they are available at once', async () => {
  const { decoded, images } = setUp(9_000);
  const image = imageOf('a');
  expect(images.find(image)).toBeUndefined();
  const [first, second] = await Promise.all([images.load(image), images.load(image)]);
  expect(images.find(image)).toBe(first);
  expect(second).toBe(first);
  expect(await images.load(image)).toBe(first);
  expect(decoded).toEqual(['a']);
});

it('drops the least recently used images beyond its limit', async () => {
  const { decoded, images } = setUp(3_000);
  const all = ['a', 'b', 'c', 'd', 'e'].map(imageOf);
  const [a, b, c, d, e] = all as [CharacterImage, CharacterImage, CharacterImage, CharacterImage, CharacterImage]; // prettier-ignore
  for (const image of [a, b, c]) await images.load(image);
  expect(images.find(a)).toBeDefined();
  await images.load(d);
  expect([a, b, c, d, e].filter((image) => images.find(image))).toEqual([a, c, d]);
  await images.load(b);
  expect(decoded.filter((name) => name === 'b')).toHaveLength(2);
});

it('keeps no image that is larger than its limit, and no failure', async () => {
  const { decoded, images } = setUp(999);
  const [large, broken] = [imageOf('large'), imageOf('broken')];
  await images.load(large);
  expect(images.find(large)).toBeUndefined();
  expect(await images.load(broken)).toBe('no picture');
  expect(images.find(broken)).toBeUndefined();
  expect(decoded).toEqual(['large', 'broken']);
});
