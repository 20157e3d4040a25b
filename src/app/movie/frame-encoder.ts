import { Failure } from '../../core/failure.ts';

/** At most so many frames wait; the encoder has some in work besides. */
const mostWaiting = 4;

/** A packet with what the encoder tells about it. */
export interface Packet {
  readonly chunk: EncodedVideoChunk;
  readonly meta: EncodedVideoChunkMetadata | undefined;
}

/** Encodes frames in their order, and lets few of them wait. */
export class FrameEncoder {
  private readonly encoder: VideoEncoder;
  private fault: DOMException | null = null;
  private wake: () => void = () => undefined;

  /** @param onPacket receives the packets in their order */
  constructor(config: VideoEncoderConfig, onPacket: (packet: Packet) => void) {
    this.encoder = new VideoEncoder({
      output: (chunk, meta) => {
        onPacket({ chunk, meta });
      },
      error: (fault) => {
        this.fault = fault;
        this.wake();
      },
    });
    this.encoder.ondequeue = () => this.wake();
    this.encoder.configure(config);
  }

  /** Takes a frame over, and returns when there is room for another. */
  async add(frame: VideoFrame, keyFrame: boolean): Promise<void> {
    try {
      this.check();
      this.encoder.encode(frame, { keyFrame });
    } finally {
      frame.close();
    }
    while (this.encoder.state === 'configured' && this.encoder.encodeQueueSize >= mostWaiting) {
      await new Promise<void>((resolve) => (this.wake = resolve));
    }
    this.check();
  }

  /** Returns when all packets are out. */
  async finish(): Promise<void> {
    this.check();
    await this.encoder.flush();
    this.check();
  }

  close(): void {
    if (this.encoder.state !== 'closed') this.encoder.close();
    this.wake();
  }

  private check(): void {
    const { fault } = this;
    if (!fault && this.encoder.state === 'configured') return;
    throw new Failure(`The browser's video encoder stopped: ${fault?.message ?? 'it is closed'}`, {
      cause: fault,
    });
  }
}
