/**
 * A WebGL2 context in memory. Data written to buffers and float textures can be read back and is
 * counted. All other calls do nothing.
 */
export class FakeGl {
  /** Bytes that were sent to buffers and textures, without those that only reserve memory. */
  uploadedBytes = 0;
  readonly buffers: FakeBuffer[] = [];
  readonly textures: FakeTexture[] = [];
  private boundBuffer: FakeBuffer | null = null;
  private boundTexture: FakeTexture | null = null;

  /** The context for the code under test. */
  readonly context: WebGL2RenderingContext;

  constructor() {
    const calls: Readonly<Record<string, unknown>> = {
      getParameter: () => 16384,
      getError: () => 0,
      createBuffer: () => this.keep(this.buffers, { bytes: new Uint8Array(0) }),
      bindBuffer: (_: number, buffer: FakeBuffer | null) => (this.boundBuffer = buffer),
      bufferData: (_: number, content: ArrayBufferView | number) => {
        const reserved = typeof content === 'number' ? content : content.byteLength;
        this.boundBuffer!.bytes = new Uint8Array(reserved);
        if (typeof content !== 'number') this.send(content, this.boundBuffer!.bytes, 0);
      },
      bufferSubData: (_: number, offset: number, content: ArrayBufferView) => {
        this.send(content, this.boundBuffer!.bytes, offset);
      },
      createTexture: () => this.keep(this.textures, { width: 0, texels: new Float32Array(0) }),
      bindTexture: (_: number, texture: FakeTexture | null) => (this.boundTexture = texture),
      texStorage2D: (...[, , format, width, height]: number[]) => {
        const size = format === constant('RG32F') ? 2 : 4;
        this.boundTexture!.width = width! * size;
        this.boundTexture!.texels = new Float32Array(width! * height! * size);
      },
      texSubImage2D: (...args: unknown[]) => {
        const [, , x, y, width, height, layout] = args as number[];
        const { texels, width: stride } = this.boundTexture!;
        const size = layout === constant('RG') ? 2 : 4;
        const pixels = args[8] as Float32Array;
        for (let row = 0; row < height!; row++) {
          const from = pixels.subarray(row * width! * size, (row + 1) * width! * size);
          texels.set(from, (y! + row) * stride + x! * size);
        }
        this.uploadedBytes += width! * height! * size * 4;
      },
    };
    this.context = new Proxy({} as WebGL2RenderingContext, {
      get: (_, name: string) => {
        if (name in calls) return calls[name];
        return name === name.toUpperCase() ? constant(name) : () => ({});
      },
    });
  }

  private keep<T>(list: T[], item: T): T {
    list.push(item);
    return item;
  }

  private send({ buffer, byteOffset, byteLength }: ArrayBufferView, to: Uint8Array, at: number) {
    to.set(new Uint8Array(buffer, byteOffset, byteLength), at);
    this.uploadedBytes += byteLength;
  }
}

interface FakeBuffer {
  bytes: Uint8Array;
}

interface FakeTexture {
  /** The number of floats in a row. */
  width: number;
  texels: Float32Array;
}

/** Returns a number for a constant's name; any will do as long as no two are equal. */
function constant(name: string): number {
  if (!constants.has(name)) constants.set(name, 1 + constants.size);
  return constants.get(name)!;
}

const constants = new Map<string, number>();
