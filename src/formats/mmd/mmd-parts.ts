import type { Character, CharacterExtra } from '../../core/character.ts';

/**
 * What an MMD character file (PMD) has beyond the parts that all formats share: for motions, which
 * need its IK chains and kinds of bones, and for writing. Right-handed as all of Sinew is; joints,
 * points, morphs and bodies by their index in the file, -1 for none.
 */
export interface MmdParts extends CharacterExtra {
  /** By this `mmdOf` knows it again, on the other side of a worker too. */
  readonly kind: 'mmd';
  readonly version: number;
  readonly modelName: string;
  readonly comment: string;
  /** In file order. */
  readonly bones: readonly MmdBone[];
  readonly vertices: MmdVertices;
  readonly ikChains: readonly IkChain[];
  readonly morphs: MmdMorphs;
  readonly display: MmdDisplay;
  /** Names in a second language, where the file has them. */
  readonly english?: MmdEnglish;
  /** Names of the images that shade, by the toon index of a material; empty where the file has none. */
  readonly toons: readonly string[];
  /** Where the file has the section. */
  readonly physics?: MmdPhysics;
}

/** What the character has of an MMD file, if it has any. */
export function mmdOf({ extra }: Character): MmdParts | undefined {
  return isMmd(extra) ? extra : undefined;
}

function isMmd(extra: CharacterExtra | undefined): extra is MmdParts {
  return extra !== undefined && 'kind' in extra && extra.kind === 'mmd';
}

/** What a bone may do, as the file numbers it. */
export const MmdBoneType = {
  rotate: 0,
  rotateAndMove: 1,
  ik: 2,
  unknown: 3,
  underIk: 4,
  underRotation: 5,
  ikTarget: 6,
  hidden: 7,
  twist: 8,
  rotationLink: 9,
} as const;

export interface MmdBone {
  /** See `MmdBoneType`. */
  readonly type: number;
  /** The bone that it points to. */
  readonly tail: number;
  /**
   * As in the file: of type 4 the IK bone, of type 5 the bone whose rotation it takes, of type 9 the
   * percentage that it takes of its tail's.
   */
  readonly ikParent: number;
}

/** A row a point, as the file has it: what mesh and skin no longer tell. */
export interface MmdVertices {
  /** (pointCount × 3) of any length. */
  readonly normals: Float32Array;
  /** (pointCount × 2) v counts downwards here, upwards in the mesh. */
  readonly uvs: Float32Array;
  /** (pointCount × 2) file indices; they may name no bone where their weight is 0. */
  readonly bones: Uint16Array;
  /** (pointCount) hundredths of the first bone, 0 to 100. */
  readonly weights: Uint8Array;
  /** (pointCount) 1 where no outline is drawn. */
  readonly edgeFlags: Uint8Array;
}

/** A bone that others reach for. */
export interface IkChain {
  /** Where the effector should come to. */
  readonly goal: number;
  readonly effector: number;
  readonly iterations: number;
  /** The most that a link turns in an iteration, in units of 4 radians, as in the file. */
  readonly limit: number;
  /** From the one next to the effector upwards. */
  readonly links: readonly number[];
}

export interface MmdMorphs {
  /** The points that morphs move, and where they are without any (n × 3). */
  readonly basePoints: Uint32Array;
  readonly basePositions: Float32Array;
  /** In file order; the base itself among them, with what morph of the character each is, or -1. */
  readonly listed: readonly MmdMorph[];
}

export interface MmdMorph {
  readonly fileName: string;
  /** 0 base, 1 brow, 2 eye, 3 lip, 4 other. */
  readonly panel: number;
  /** Index in the character's `morphs`. */
  readonly morph: number;
}

/** How a program lists morphs and bones. */
export interface MmdDisplay {
  /** Indices into `MmdMorphs.listed`. */
  readonly morphs: readonly number[];
  readonly groupNames: readonly string[];
  /** Group 0 has no name: it is the root's; 1 is the first of `groupNames`. */
  readonly bones: readonly { readonly bone: number; readonly group: number }[];
}

export interface MmdEnglish {
  readonly modelName: string;
  readonly comment: string;
  readonly boneNames: readonly string[];
  /** Without the base. */
  readonly morphNames: readonly string[];
  readonly groupNames: readonly string[];
}

export interface MmdPhysics {
  readonly bodies: readonly RigidBody[];
  readonly joints: readonly BodyJoint[];
}

export type Numbers3 = readonly [number, number, number];

export interface RigidBody {
  readonly name: string;
  readonly bone: number;
  /** 0 to 15, and a mask of those that it collides with. */
  readonly group: number;
  readonly mask: number;
  readonly shape: 'sphere' | 'box' | 'capsule';
  /** Radius, height and depth, as the shape uses them, model units. */
  readonly size: Numbers3;
  /** From the bone, model units. */
  readonly position: Numbers3;
  /** Radians about x, y, z. */
  readonly rotation: Numbers3;
  readonly mass: number;
  readonly linearDamping: number;
  readonly angularDamping: number;
  readonly restitution: number;
  readonly friction: number;
  /** 0 follows its bone, 1 moves it, 2 moves it and keeps its place. */
  readonly mode: number;
}

/** A spring between two rigid bodies. */
export interface BodyJoint {
  readonly name: string;
  readonly bodies: readonly [number, number];
  readonly position: Numbers3;
  readonly rotation: Numbers3;
  readonly positionMin: Numbers3;
  readonly positionMax: Numbers3;
  readonly rotationMin: Numbers3;
  readonly rotationMax: Numbers3;
  readonly positionSpring: Numbers3;
  readonly rotationSpring: Numbers3;
}
