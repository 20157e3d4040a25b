/** The largest inputs that Sinew takes; arguments with these defaults, so that tests pass small ones. */
export interface Limits {
  /** Bytes of a file, and of what a packed file unfolds to. */
  readonly fileSize: number;
  /** Bytes of a line of text. */
  readonly lineLength: number;
  /** Characters of a number. */
  readonly tokenLength: number;
  readonly jointCount: number;
  readonly pointCount: number;
  readonly triangleCount: number;
  readonly cornersPerFace: number;
  /** How deep joints and blocks of a text file may nest. */
  readonly depth: number;
  /** Magnitude of a coordinate or offset: its square, which lengths need, is still a float32. */
  readonly coordinate: number;
  /** Magnitude of a weight: with any coordinate, blended matrices and their cofactors stay finite. */
  readonly weight: number;
}

export const defaultLimits: Limits = {
  fileSize: 256 * 1024 * 1024,
  lineLength: 1024 * 1024,
  tokenLength: 64,
  jointCount: 4096,
  pointCount: 4_000_000,
  triangleCount: 8_000_000,
  cornersPerFace: 10_000,
  depth: 1024,
  coordinate: 1e18,
  weight: 1e6,
};
