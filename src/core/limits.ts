/** The largest inputs that Sinew takes; arguments with these defaults, so that tests pass small ones. */
export interface Limits {
  readonly jointCount: number;
  readonly pointCount: number;
  readonly triangleCount: number;
  readonly cornersPerFace: number;
  readonly tokenLength: number;
  /** How deep joints and blocks of a text file may nest. */
  readonly depth: number;
}

export const defaultLimits: Limits = {
  jointCount: 4096,
  pointCount: 4_000_000,
  triangleCount: 8_000_000,
  cornersPerFace: 10_000,
  tokenLength: 64,
  depth: 1024,
};
