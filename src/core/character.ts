import type { Bone } from './bones.ts';
import type { Bounds } from './bounds.ts';
import type { ClipParts, FileSpace, MaterialParts } from './character-parts.ts';
import type { Mesh } from './mesh.ts';
import type { Morph } from './morph.ts';
import type { Skeleton } from './skeleton.ts';
import type { Skin } from './skin.ts';

/** An image as it was read; whoever draws decodes it. */
export interface CharacterImage {
  /** The plain path of what the material names, as it can stand in an archive. */
  readonly name: string;
  /** What materials say for it, as their file has it. */
  readonly textures: readonly string[];
  readonly bytes: Uint8Array;
}

/**
 * A character, checked and packed by `buildCharacter`; it never changes. A part that was not in the
 * files is empty (no joints, no points), so nothing further down asks whether it is there.
 */
export interface Character {
  readonly name: string;
  readonly skeleton: Skeleton;
  readonly mesh: Mesh;
  readonly skin: Skin;
  /** Shapes that are added to the mesh before it is skinned. */
  readonly morphs: readonly Morph[];
  /** As read; an actor has its own. */
  readonly clips: readonly ClipParts[];
  /** By the name that submeshes have. */
  readonly materials: readonly MaterialParts[];
  /** The image files that materials name, as far as they were there. */
  readonly images: readonly CharacterImage[];
  readonly bones: readonly Bone[];
  /** Of mesh and joints at the file's pose, character space. */
  readonly bounds: Bounds;
  /** What was not there, for the user: kinds of file (".attach") and images ("head.bmp"). */
  readonly missing: readonly string[];
  readonly meta: CharacterMeta;
  /** Names of images that go with the files and may stay away: nothing that is shown needs them. */
  readonly optionalImages: readonly string[];
  readonly extra?: CharacterExtra;
}

/**
 * What a file has beyond the parts that all formats share. The format's own folder types it and knows
 * it again; everyone else hands it on.
 */
export interface CharacterExtra {
  /** What it holds, in words, for whoever leaves it out and says so. */
  readonly summary: string;
}

/** About the files that a character came from, for writers; nothing further down asks for it. */
export interface CharacterMeta {
  readonly fileSpace: FileSpace;
}
