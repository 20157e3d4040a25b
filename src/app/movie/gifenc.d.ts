/** The parts of gifenc that are used; the package has no types of its own. */
declare module 'gifenc/dist/gifenc.esm.js' {
  type Color = readonly [red: number, green: number, blue: number];

  interface FrameOptions {
    /** Whether the file's head comes before it. */
    readonly first: boolean;
    /** With the first frame that of the file; with others, one of their own. */
    readonly palette: readonly Color[] | null;
    /** In milliseconds, rounded to hundredths of a second. */
    readonly delay: number;
    readonly transparent: boolean;
    readonly transparentIndex: number;
    /** How often the movie is repeated; 0 is for ever. */
    readonly repeat: number;
  }

  interface Encoder {
    writeHeader(): void;
    writeFrame(indices: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    /** A copy of what was written since the last reset. */
    bytes(): Uint8Array<ArrayBuffer>;
    reset(): void;
  }

  /** @param options `auto` writes the head by itself */
  export function GIFEncoder(options: { readonly auto: boolean }): Encoder;

  /** Returns at most `count` colors for pixels of RGBA. */
  export function quantize(
    pixels: Uint8Array | Uint8ClampedArray,
    count: number,
    options?: { readonly format?: 'rgb565' | 'rgb444' | 'rgba4444' },
  ): Color[];
}
