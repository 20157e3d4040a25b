import type { Character, CharacterExtra } from '../../core/character.ts';

/**
 * Data of an MMD character file (PMD) beyond the parts that all formats share. Motions need its IK
 * chains and kinds of bones, and writers need all of it. It is right-handed like everything in
 * Sinew. Joints, points, morphs and bodies are given by their index in the file, -1 for none.
 */
export interface MmdParts extends CharacterExtra {
  /** The tag by which `mmdOf` recognizes it, also after a transfer between threads. */
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
  /** Names in a second language, if the file has them. */
  readonly english?: MmdEnglish;
  /** Names of the toon ramp images, by the toon index of a material; empty if the file has none. */
  readonly toons: readonly string[];
  /** Absent if the file has no such section. */
  readonly physics?: MmdPhysics;
}

/** Returns the MMD data of a character, if it has any. */
export function mmdOf({ extra }: Character): MmdParts | undefined {
  return isMmd(extra) ? extra : undefined;
}

function isMmd(extra: CharacterExtra | undefined): extra is MmdParts {
  return extra !== undefined && 'kind' in extra && extra.kind === 'mmd';
}

/** The kinds of bones, as the file numbers them. */
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
  /** The bone to which it points. */
  readonly tail: number;
  /**
   * As in the file: for type 4 the IK bone, for type 5 the bone whose rotation it copies, for type
   * 9 the percentage of its tail's rotation that it copies.
   */
  readonly ikParent: number;
  /** Its position at rest, in the model's space and units; single floats, as the file has them. */
  readonly head: Numbers3;
}

/** A row per point, as the file has it: data that mesh and skin do not keep. */
export interface MmdVertices {
  /** (pointCount × 3) of any length. */
  readonly normals: Float32Array;
  /** (pointCount × 2) v counts downwards here, but upwards in the mesh. */
  readonly uvs: Float32Array;
  /** (pointCount × 2) file indices; they may name no bone if their weight is 0. */
  readonly bones: Uint16Array;
  /** (pointCount) hundredths of the first bone, 0 to 100. */
  readonly weights: Uint8Array;
  /** (pointCount) 1 if no outline is drawn. */
  readonly edgeFlags: Uint8Array;
}

/** An IK chain: a goal bone and the chain of bones that reaches for it. */
export interface IkChain {
  /** The bone whose position the effector should reach. */
  readonly goal: number;
  readonly effector: number;
  readonly iterations: number;
  /** The largest rotation of a link per iteration, in units of 4 radians, as in the file. */
  readonly limit: number;
  /** From the bone next to the effector upwards. */
  readonly links: readonly number[];
}

export interface MmdMorphs {
  /** The points that morphs move, and their positions without any morph (n × 3). */
  readonly basePoints: Uint32Array;
  readonly basePositions: Float32Array;
  /** In file order, including the base; each with the index of the character's morph, or -1. */
  readonly listed: readonly MmdMorph[];
}

export interface MmdMorph {
  readonly fileName: string;
  /** 0 base, 1 brow, 2 eye, 3 lip, 4 other. */
  readonly panel: number;
  /** Index in the character's `morphs`. */
  readonly morph: number;
}

/** The order in which a program lists morphs and bones. */
export interface MmdDisplay {
  /** Indices into `MmdMorphs.listed`. */
  readonly morphs: readonly number[];
  readonly groupNames: readonly string[];
  /** Group 0 has no name and belongs to the root; group 1 is the first of `groupNames`. */
  readonly bones: readonly { readonly bone: number; readonly group: number }[];
}

export interface MmdEnglish {
  readonly modelName: string;
  readonly comment: string;
  readonly boneNames: readonly string[];
  /** Without the base morph. */
  readonly morphNames: readonly string[];
  readonly groupNames: readonly string[];
}

export interface MmdPhysics {
  readonly bodies: readonly RigidBody[];
  readonly joints: readonly BodyJoint[];
}

export type Numbers3 = readonly [number, number, number];

/** The shapes of rigid bodies, as the file numbers them. */
export const bodyShapes = ['sphere', 'box', 'capsule'] as const;

export interface RigidBody {
  readonly name: string;
  readonly bone: number;
  /** 0 to 15, and a mask of the groups with which it collides. */
  readonly group: number;
  readonly mask: number;
  readonly shape: (typeof bodyShapes)[number];
  /** Radius, height and depth, as the shape uses them, in model units. */
  readonly size: Numbers3;
  /** Relative to the bone, in model units. */
  readonly position: Numbers3;
  /** Radians about x, y, z. */
  readonly rotation: Numbers3;
  readonly mass: number;
  readonly linearDamping: number;
  readonly angularDamping: number;
  readonly restitution: number;
  readonly friction: number;
  /** 0 follows its bone, 1 moves it, 2 moves it and keeps its position. */
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
