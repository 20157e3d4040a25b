import { atlas, type Region, textureSize } from './atlas.ts';
import {
  paintAbdomen,
  paintAntenna,
  paintEye,
  paintHead,
  paintLeg,
  paintMandible,
  paintTarsus,
  paintThorax,
} from './colors.ts';
import { indexedPng } from './indexed-png.ts';
import type { Color } from './paint.ts';
import { paintWing } from './wing-veins.ts';

/** The color of a part at a place along it and across it, both from 0 to 1. */
type Painter = (along: number, across: number) => Color;

const painters: readonly (readonly [Region, Painter])[] = [
  [atlas.abdomen, paintAbdomen],
  [atlas.thorax, paintThorax],
  [atlas.head, paintHead],
  [atlas.wing, paintWing],
  [atlas.leg, paintLeg],
  [atlas.tarsus, paintTarsus],
  [atlas.antenna, paintAntenna],
  [atlas.eye, paintEye],
  [atlas.mandible, paintMandible],
];

/**
 * The number of colors in the picture's palette, which looks the same and takes far fewer bytes
 * than full color.
 */
const colorCount = 256;

/** Paints the texture and returns a PNG. */
export function paintTexture(): Buffer {
  const pixels = new Uint8Array(textureSize * textureSize * 3);
  for (const [{ left, top, width, height }, paint] of painters) {
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const color = paint((x + 0.5) / width, (y + 0.5) / height);
        const at = ((top + y) * textureSize + left + x) * 3;
        color.forEach((value, channel) => {
          pixels[at + channel] = Math.round(Math.min(1, Math.max(0, value)) * 255);
        });
      }
    }
  }
  return indexedPng(pixels, textureSize, colorCount);
}
