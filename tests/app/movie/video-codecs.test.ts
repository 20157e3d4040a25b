import { expect, it } from 'vitest';
import {
  encoderConfig,
  mp4Codecs,
  webmCodecs,
  whyNoVideo,
} from '../../../src/app/movie/video-codecs.ts';
import { planOf } from './fake-source.ts';

it('codecs are named with the lowest level that allows the movie', () => {
  const nameOf = (
    index: 0 | 1,
    format: 'webm' | 'mp4',
    width: number,
    height: number,
    rate: number,
  ) =>
    (format === 'webm' ? webmCodecs : mp4Codecs)[index]!.nameFor(
      planOf({ format, width, height, rate }),
    );
  expect(nameOf(0, 'webm', 160, 96, 30)).toBe('vp09.00.10.08');
  expect(nameOf(0, 'webm', 1920, 1080, 30)).toBe('vp09.00.40.08');
  expect(nameOf(0, 'webm', 1920, 1080, 60)).toBe('vp09.00.41.08');
  expect(nameOf(1, 'webm', 1920, 1080, 60)).toBe('vp8');
  expect(nameOf(0, 'mp4', 1280, 720, 30)).toBe('avc1.64001f');
  expect(nameOf(0, 'mp4', 1920, 1080, 30)).toBe('avc1.640028');
  expect(nameOf(1, 'mp4', 1920, 1080, 60)).toBe('avc1.42002a');
  expect(nameOf(0, 'mp4', 3840, 2160, 60)).toBe('avc1.640034');
});

it('a larger or faster movie has more bits, within bounds', () => {
  const bits = (width: number, rate: number): number =>
    encoderConfig(webmCodecs[0]!, planOf({ width, height: 360, rate })).bitrate!;
  expect(bits(640, 30)).toBe(640 * 360 * 30 * 0.2);
  expect(bits(1280, 60)).toBe(4 * bits(640, 30));
  expect(bits(16, 1)).toBe(400_000);
});

it('a browser without an encoder says so', async () => {
  expect('VideoEncoder' in globalThis).toBe(false);
  Object.assign(globalThis, { isSecureContext: true });
  expect(await whyNoVideo(planOf({}), webmCodecs, 'VP9')).toBe('This browser encodes no video');
  Object.assign(globalThis, { isSecureContext: false });
  expect(await whyNoVideo(planOf({}), webmCodecs, 'VP9')).toContain('https');
  delete (globalThis as { isSecureContext?: boolean }).isSecureContext;
});
