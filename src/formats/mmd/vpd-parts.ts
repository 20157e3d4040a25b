/** The beginning of every pose of MikuMikuDance. */
export const signature = 'Vocaloid Pose Data file';

/** A pose of MikuMikuDance as its file has it, in the file's left-handed space. */
export interface Vpd {
  /** The file of the model that it was made with, such as `初音ミク.osm`. */
  readonly model: string;
  readonly bones: readonly VpdBone[];
  readonly morphs: readonly VpdMorph[];
}

export interface VpdBone {
  readonly name: string;
  /** Its line in the file; 0 if it comes from none. */
  readonly line: number;
  /** The offset from its place at rest. */
  readonly position: readonly [number, number, number];
  /** Quaternion xyzw, as written: rounded to six digits it is rarely of length 1. */
  readonly rotation: readonly [number, number, number, number];
}

export interface VpdMorph {
  readonly name: string;
  readonly line: number;
  readonly weight: number;
}
