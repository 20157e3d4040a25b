import { expect, it } from 'vitest';
import { plainSettings, pictureSizeOf } from '../../../src/view/picture/picture-size.ts';

const framed = { width: 900, height: 600 };

it.each([
  ['view', 3 / 2, [900, 600]],
  ['1080p', 16 / 9, [1920, 1080]],
  ['1080p', 4 / 5, [1080, 1350]],
  ['4k', 16 / 9, [3840, 2160]],
  ['4k', null, [3240, 2160]],
  ['a4', 210 / 297, [2480, 3508]],
  ['a4', 3 / 2, [3508, 2339]],
  ['a4', 1, [2480, 2480]],
  ['free', 4 / 5, [1920, 2400]],
  ['free', null, [1920, 1080]],
] as const)('%s with a ratio of %s', (size, ratio, [width, height]) => {
  expect(pictureSizeOf({ ...plainSettings, size }, framed, ratio)).toEqual({ width, height });
});
