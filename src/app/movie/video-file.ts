import {
  EncodedPacket,
  EncodedVideoPacketSource,
  Mp4OutputFormat,
  Output,
  StreamTarget,
  WebMOutputFormat,
} from 'mediabunny';
import type { MoviePlan } from '../../view/movie/movie-plan.ts';
import type { MovieSource } from '../../view/movie/movie-source.ts';
import type { Picture } from '../../view/picture/encode-picture.ts';
import { FrameEncoder, type Packet } from './frame-encoder.ts';
import { GrowingFile } from './growing-file.ts';
import type { MovieSink } from './movie-format.ts';
import { encoderConfig, type VideoCodecRow } from './video-codecs.ts';

/** A frame that others do not depend on comes at least every so many seconds, to seek to. */
const secondsBetweenKeys = 2;
const microseconds = 1e6;

/** Begins a video. In WebM what is transparent has a second stream of alpha beside the colors. */
export async function openVideo(
  { plan }: MovieSource,
  container: 'webm' | 'mp4',
  codec: VideoCodecRow,
): Promise<MovieSink> {
  const { rate } = plan;
  const isTransparent = container === 'webm' && !plan.background;
  const file = new GrowingFile();
  const target = new StreamTarget(new WritableStream({ write: (chunk) => file.write(chunk) }));
  const format =
    container === 'webm' ? new WebMOutputFormat() : new Mp4OutputFormat({ fastStart: 'in-memory' });
  const output = new Output({ format, target });
  const track = new EncodedVideoPacketSource(codec.name);
  output.addVideoTrack(track, { frameRate: rate });
  await output.start();

  const colors: Packet[] = [];
  const alphas: Packet[] = [];
  let written = Promise.resolve();
  const config = encoderConfig(codec, plan);
  const encoderInto = (packets: Packet[]): FrameEncoder =>
    new FrameEncoder(config, (packet) => {
      packets.push(packet);
      write();
    });
  const encoders = [encoderInto(colors)];
  if (isTransparent) encoders.push(encoderInto(alphas));
  const keyEvery = Math.max(1, Math.round(secondsBetweenKeys * rate));
  return {
    async add(frame) {
      const picture = await frame.picture();
      const isKey = frame.index % keyEvery === 0;
      const times = timesOf(frame.index, plan);
      const frames = [colorFrame(picture, times)];
      if (isTransparent) frames.push(alphaFrame(picture, times));
      await Promise.all(frames.map((each, i) => encoders[i]!.add(each, isKey)));
      await written;
    },
    async finish() {
      for (const encoder of encoders) await encoder.finish();
      await written;
      await output.finalize();
      return file.finish(`video/${container}`);
    },
    close() {
      for (const encoder of encoders) encoder.close();
      if (output.state !== 'finalized') output.cancel().catch(() => undefined);
      file.close();
    },
  };

  /** Writes the packets that are complete, one after another. */
  function write(): void {
    while (colors.length > 0 && (!isTransparent || alphas.length > 0)) {
      const { chunk, meta } = colors.shift()!;
      const alpha = isTransparent ? alphas.shift()! : null;
      // The encoder counts in whole microseconds.
      const index = Math.round((chunk.timestamp * rate) / microseconds);
      const sideData = alpha ? { alpha: bytesOf(alpha.chunk) } : undefined;
      const packet = new EncodedPacket(
        ...([bytesOf(chunk), chunk.type, index / rate, 1 / rate] as const),
        ...([undefined, undefined, sideData] as const),
      );
      written = written.then(() => track.add(packet, meta));
      written.catch(() => undefined); // a fault is thrown where it is awaited, unless all is closed
    }
  }
}

/** The time and duration of a frame in microseconds. */
function timesOf(index: number, { rate }: MoviePlan) {
  const at = (frame: number): number => Math.round((frame * microseconds) / rate);
  return { timestamp: at(index), duration: at(index + 1) - at(index) };
}

type FrameTimes = ReturnType<typeof timesOf>;

function colorFrame({ width, height, pixels }: Picture, times: FrameTimes): VideoFrame {
  return new VideoFrame(pixels, {
    ...{ format: 'RGBX', codedWidth: width, codedHeight: height },
    ...times,
  });
}

/** Alpha as the lightness of a gray picture. */
function alphaFrame({ width, height, pixels }: Picture, times: FrameTimes): VideoFrame {
  const count = width * height;
  const planes = new Uint8Array((count * 3) / 2).fill(128, count);
  for (let pixel = 0; pixel < count; pixel++) planes[pixel] = pixels[pixel * 4 + 3]!;
  return new VideoFrame(planes, {
    ...{ format: 'I420', codedWidth: width, codedHeight: height },
    ...times,
  });
}

function bytesOf(chunk: EncodedVideoChunk): Uint8Array {
  const bytes = new Uint8Array(chunk.byteLength);
  chunk.copyTo(bytes);
  return bytes;
}
