/**
 * The largest inputs that Sinew accepts. Functions take them as arguments with these defaults, so
 * that tests can pass small ones.
 */
export interface Limits {
  /** Bytes of a file, packed and unpacked. */
  readonly fileSize: number;
  /** Bytes per line of text. */
  readonly lineLength: number;
  /** Characters per number. */
  readonly tokenLength: number;
  readonly jointCount: number;
  readonly pointCount: number;
  readonly triangleCount: number;
  readonly cornersPerFace: number;
  /** How deeply joints and blocks of a text file may nest. */
  readonly depth: number;
  /**
   * Magnitude of a coordinate or an offset. Lengths need its square, which is still a finite
   * float32.
   */
  readonly coordinate: number;
  /**
   * Magnitude of a weight. With any allowed coordinate, blended matrices and their cofactors stay
   * finite.
   */
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
