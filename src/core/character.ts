import type { Bounds } from './bounds.ts';
import type { FileSpace, IkChain, MaterialParts, RotationLink } from './character-parts.ts';
import type { ClipParts } from './motion/clip-parts.ts';
import type { Mesh } from './mesh.ts';
import type { Morph } from './morph.ts';
import type { Skeleton } from './skeleton.ts';
import type { Skin } from './skin.ts';

/** An image file as it was read; the view decodes it. */
export interface CharacterImage {
  /** The path that the material names, made plain so that it can be used in an archive. */
  readonly name: string;
  /** The texture names by which materials refer to this image, as their file has them. */
  readonly textures: readonly string[];
  readonly bytes: Uint8Array;
}

/**
 * A character that `buildCharacter` has checked and packed; it never changes. A part that was
 * missing from the files is empty (no joints, no points), so later code does not need to check for
 * it.
 */
export interface Character {
  readonly name: string;
  readonly skeleton: Skeleton;
  readonly mesh: Mesh;
  readonly skin: Skin;
  /** Morph targets, which are added to the mesh before skinning. */
  readonly morphs: readonly Morph[];
  /** Clips as read from the files; an actor has a list of its own. */
  readonly clips: readonly ClipParts[];
  /** Materials; submeshes refer to them by name. */
  readonly materials: readonly MaterialParts[];
  /** The image files that materials name, if they were found. */
  readonly images: readonly CharacterImage[];
  /** Bounds of the mesh and the joints in the file's pose, in the character's space. */
  readonly bounds: Bounds;
  /** What was missing, for the user: kinds of file (".attach") and images ("head.bmp"). */
  readonly missing: readonly string[];
  readonly meta: CharacterMeta;
  /**
   * Names of images that belong to the files but that nothing shown needs, so they may be missing.
   */
  readonly optionalImages: readonly string[];
  /** Joints that copy rotations of others where the character is shown, in the order of the file. */
  readonly rotationLinks: readonly RotationLink[];
  /** The chains of the file, in its order. */
  readonly ikChains: readonly IkChain[];
  readonly extra?: CharacterExtra;
}

/**
 * Data of a file beyond the parts that all formats share. Only the format's own folder knows its
 * type; all other code passes it on.
 */
export interface CharacterExtra {
  /** A short description for the message that says it was left out. */
  readonly summary: string;
}

/** Facts about the files that a character came from, for writers; other code does not read them. */
export interface CharacterMeta {
  readonly fileSpace: FileSpace;
  /** The format of its files, for display alone. */
  readonly format?: string;
}
