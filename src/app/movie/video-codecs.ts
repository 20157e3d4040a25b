import { Failure } from '../../core/failure.ts';
import { type MoviePlan, movieSeconds } from '../../view/movie/movie-plan.ts';

/** A way to encode video. */
export interface VideoCodecRow {
  /** As the container names it. */
  readonly name: 'vp9' | 'vp8' | 'avc';
  /** The codec with its profile and level for a movie, as WebCodecs takes it. */
  nameFor(plan: MoviePlan): string;
}

/** The better first. */
export const webmCodecs: readonly VideoCodecRow[] = [
  { name: 'vp9', nameFor: (plan) => `vp09.00.${levelOf(plan, vp9Levels)}.08` },
  { name: 'vp8', nameFor: () => 'vp8' },
];

/** High profile, and Baseline where that is not encoded. */
export const mp4Codecs: readonly VideoCodecRow[] = [
  { name: 'avc', nameFor: (plan) => `avc1.6400${levelOf(plan, avcLevels)}` },
  { name: 'avc', nameFor: (plan) => `avc1.4200${levelOf(plan, avcLevels)}` },
];

/** A level: its name, and the most samples a second and a picture that it allows. */
type Level = readonly [name: string, perSecond: number, perPicture: number];

/** Levels of VP9 (VP9 Levels and Decoder Testing, table 1). */
const vp9Levels: readonly Level[] = [
  ['10', 829_440, 36_864],
  ['11', 2_764_800, 73_728],
  ['20', 4_608_000, 122_880],
  ['21', 9_216_000, 245_760],
  ['30', 20_736_000, 552_960],
  ['31', 36_864_000, 983_040],
  ['40', 83_558_400, 2_228_224],
  ['41', 160_432_128, 2_228_224],
  ['50', 311_951_360, 8_912_896],
  ['51', 588_251_136, 8_912_896],
  ['52', 1_176_502_272, 8_912_896],
  ['60', 1_176_502_272, 35_651_584],
  ['61', 2_353_004_544, 35_651_584],
];

/** Levels of H.264 in hexadecimal (ITU-T H.264, table A-1), of blocks of 256 samples. */
const avcLevels: readonly Level[] = (
  [
    ['0b', 3_000, 396],
    ['15', 19_800, 792],
    ['1e', 40_500, 1_620],
    ['1f', 108_000, 3_600],
    ['28', 245_760, 8_192],
    ['2a', 522_240, 8_704],
    ['33', 983_040, 36_864],
    ['34', 2_073_600, 36_864],
    ['3e', 16_711_680, 139_264],
  ] as const
).map(([name, perSecond, perPicture]) => [name, perSecond * 256, perPicture * 256]);

/** The lowest level that allows a movie, or the highest. */
function levelOf({ size, rate }: MoviePlan, levels: readonly Level[]): string {
  const block = 16;
  const side = (pixels: number): number => Math.ceil(pixels / block) * block;
  const samples = side(size.width) * side(size.height);
  const enough = levels.find(
    ([, second, picture]) => samples * rate <= second && samples <= picture,
  );
  return (enough ?? levels.at(-1)!)[0];
}

/** Enough that smooth shading shows no blocks; a still scene takes much less. */
const bitsPerPixel = 0.2;
const [leastBits, mostBits] = [400_000, 60_000_000];

/** The rate at which a movie is encoded, in bits a second. */
export function bitsPerSecond({ size, rate }: MoviePlan): number {
  const wanted = size.width * size.height * rate * bitsPerPixel;
  return Math.round(Math.min(Math.max(wanted, leastBits), mostBits));
}

/** How a codec encodes a movie. */
export function encoderConfig(codec: VideoCodecRow, plan: MoviePlan): VideoEncoderConfig {
  return {
    codec: codec.nameFor(plan),
    ...plan.size,
    bitrate: bitsPerSecond(plan),
    framerate: plan.rate,
    latencyMode: 'quality',
    ...(codec.name === 'avc' && { avc: { format: 'avc' } }),
  };
}

/** The reason why no codec encodes a movie here, or null if one does. */
export async function whyNoVideo(
  plan: MoviePlan,
  codecs: readonly VideoCodecRow[],
  names: string,
): Promise<string | null> {
  if (!('VideoEncoder' in globalThis)) {
    return isSecureContext
      ? 'This browser encodes no video'
      : 'Browsers encode video only on pages from https or from this machine';
  }
  if (await findCodec(plan, codecs)) return null;
  const { width, height } = plan.size;
  return `This browser encodes no ${names} of ${width} × ${height} pixels`;
}

/** Returns the first codec that this browser encodes a movie with. */
export async function supportedCodec(
  plan: MoviePlan,
  codecs: readonly VideoCodecRow[],
): Promise<VideoCodecRow> {
  const found = await findCodec(plan, codecs);
  if (!found) {
    const seconds = movieSeconds(plan).toFixed(2);
    throw new Failure(`This browser encodes no such video, of ${seconds} seconds`);
  }
  return found;
}

async function findCodec(
  plan: MoviePlan,
  codecs: readonly VideoCodecRow[],
): Promise<VideoCodecRow | undefined> {
  for (const codec of codecs) {
    try {
      const { supported } = await VideoEncoder.isConfigSupported(encoderConfig(codec, plan));
      if (supported) return codec;
    } catch {
      // A browser that does not know a codec rejects its name.
    }
  }
  return undefined;
}
