import type { Character } from '../core/character.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { normalizeSkin, type Skin } from '../core/skin.ts';
import { keepInfluences } from '../core/strongest-influences.ts';
import { sameValue } from '../core/same-value.ts';
import type { NormalsId } from '../core/skin.ts';
import { type NatureSettings, plainNatures } from '../posing/natural/nature-settings.ts';
import { noPins, type Pin } from '../posing/pins/pin.ts';
import type { Unkeyed } from '../posing/unkeyed.ts';
import { type MethodId, type MethodSettings, plainSettings } from '../skinning/method.ts';
import { defaultDeformation } from '../skinning/registry.ts';
import { type ActorLook, plainLook } from './actor-look.ts';
import { type Environment, studio } from './environment.ts';
import type { SavedPose } from './saved-poses.ts';
import type { Shot } from './shots.ts';

/**
 * Everything that is saved and undone, as a value. It is never changed in place, so that older
 * scenes stay valid and undo restores the exact bits. Characters are shared by reference.
 */
export interface Scene {
  readonly actors: readonly Actor[];
  readonly environment: Environment;
  readonly shots: readonly Shot[];
  /** The library of poses, in its order. */
  readonly poses: readonly SavedPose[];
}

export type ActorId = number;

/** Where a character came from; undo restores it with the actor. */
export type Source =
  | { readonly kind: 'bundled'; readonly id: string }
  | { readonly kind: 'files'; readonly files: readonly SourceFile[] };

/** One of the files of a character. Its bytes are not a part of the scene. */
export interface SourceFile {
  readonly path: string;
  /** Of its bytes, in hexadecimal digits; empty where the browser computes none. */
  readonly sha256: string;
}

/** The source of a character that came from these files. */
export function sourceOf(
  files: readonly { readonly path: string; readonly sha256?: string }[],
): Source {
  return {
    kind: 'files',
    files: files.map(({ path, sha256 = '' }) => ({ path, sha256 })),
  };
}

/**
 * The placement of an actor in the scene, applied after the character was fitted to the common
 * size, if it was; scene space.
 */
export interface Transform {
  readonly position: readonly [number, number, number];
  /** Unit quaternion xyzw. */
  readonly rotation: readonly [number, number, number, number];
  /** Uniform, about the point between the feet, or about the file's origin if it is not fitted. */
  readonly scale: number;
}

/** A character in the scene, with its editable state. */
export interface Actor {
  readonly id: ActorId;
  /** The user's name for it; at first the character's. */
  readonly name: string;
  readonly character: Character;
  readonly source: Source;
  readonly transform: Transform;
  /**
   * Whether it is shown one unit tall with its feet at the transform's origin; otherwise in its
   * file's own units, about its file's own origin.
   */
  readonly fitted: boolean;
  /** (qCount) the pose; never written in place. */
  readonly q: Float64Array;
  /** Joints that are held where the pose is shown. */
  readonly pins: readonly Pin[];
  readonly natures: NatureSettings;
  /** (morphCount) the weight of each morph; never written in place. */
  readonly morphWeights: Float64Array;
  /** Clips are compiled on demand (`clipFor`). */
  readonly clips: readonly ClipParts[];
  /** The bound clip, an index into `clips`; its values replace those of `q` in what is shown. */
  readonly clip: number | null;
  /** What was edited while a clip is bound, and is shown instead of its values; null if nothing. */
  readonly unkeyed: Unkeyed | null;
  readonly method: MethodId;
  readonly methodSettings: MethodSettings;
  readonly normals: NormalsId;
  /**
   * Whether each row of weights is divided by its sum; otherwise the file's weights are used
   * unchanged.
   */
  readonly normalizeWeights: boolean;
  /** How many influences each point keeps, the strongest ones; null keeps all. */
  readonly influences: number | null;
  /** The weights with the user's changes, which share unchanged arrays; null if there are none. */
  readonly skin: Skin | null;
  readonly look: ActorLook;
}

/** The state of an actor that may differ from what its character's files give. */
export type KeptState = Partial<
  Pick<
    Actor,
    | 'name'
    | 'source'
    | 'transform'
    | 'fitted'
    | 'q'
    | 'pins'
    | 'natures'
    | 'morphWeights'
    | 'clips'
    | 'clip'
    | 'unkeyed'
    | 'methodSettings'
    | 'normals'
    | 'normalizeWeights'
    | 'influences'
    | 'skin'
    | 'look'
  >
>;

export const emptyScene: Scene = { actors: [], environment: studio, shots: [], poses: [] };

/** The identity: no placement by the user. */
export const unmoved: Transform = { position: [0, 0, 0], rotation: [0, 0, 0, 1], scale: 1 };

/** Makes an actor in its files' state, except for the values that are given, which are copied. */
export function createActor(
  id: ActorId,
  character: Character,
  method: MethodId,
  kept: KeptState = {},
): Actor {
  const { source = { kind: 'files', files: [] }, transform = unmoved, clip = null } = kept;
  return {
    id,
    name: kept.name ?? character.name,
    character,
    source,
    transform,
    fitted: kept.fitted ?? true,
    q: (kept.q ?? character.skeleton.qRest).slice(),
    pins: kept.pins ?? noPins,
    natures: kept.natures ?? plainNatures,
    morphWeights: kept.morphWeights?.slice() ?? new Float64Array(character.morphs.length),
    clips: kept.clips ?? character.clips,
    clip,
    unkeyed: kept.unkeyed ?? null,
    method,
    methodSettings: kept.methodSettings ?? plainSettings,
    normals: kept.normals ?? defaultDeformation(character).normals,
    normalizeWeights: kept.normalizeWeights ?? false,
    influences: kept.influences ?? null,
    skin: kept.skin ?? null,
    look: kept.look ?? plainLook,
  };
}

/** The clip that is bound to an actor, if any. */
export function boundClip({ clip, clips }: Actor): ClipParts | undefined {
  return clip === null ? undefined : clips[clip];
}

export function actorById({ actors }: Scene, id: ActorId | null): Actor | undefined {
  return actors.find((actor) => actor.id === id);
}

/** Returns an id that no actor of the scene has. */
export function freeId({ actors }: Scene): ActorId {
  return 1 + actors.reduce((largest, { id }) => Math.max(largest, id), 0);
}

/** Whether two scenes are equal, bit by bit. */
export function sameScene(a: Scene, b: Scene): boolean {
  if (a === b) return true;
  return (
    a.actors.length === b.actors.length &&
    a.actors.every((actor, i) => actor === b.actors[i] || sameActor(actor, b.actors[i]!)) &&
    sameValue(a.environment, b.environment) &&
    sameValue(a.shots, b.shots) &&
    sameValue(a.poses, b.poses)
  );
}

/** Characters are large and never changed in place, so they are compared by identity. */
function sameActor(a: Actor, b: Actor): boolean {
  const { character, ...others } = a;
  const { character: otherCharacter, ...rest } = b;
  return character === otherCharacter && sameValue(others, rest);
}

/**
 * The weights that are used: the file's with the user's changes, of these the strongest of each
 * point if only some are kept, and each row divided by its sum if they are normalized.
 */
export function skinInUse(actor: Actor): Skin {
  const { normalizeWeights, influences } = actor;
  const skin = actor.skin ?? actor.character.skin;
  const kept =
    influences === null ? skin : derived(skin, influences, () => keepInfluences(skin, influences));
  return normalizeWeights ? derived(kept, 0, () => normalizeSkin(kept)) : kept;
}

/** @param way the number of influences that are kept, or 0 for normalized weights */
function derived(skin: Skin, way: number, derive: () => Skin): Skin {
  let ways = derivedSkins.get(skin);
  if (!ways) derivedSkins.set(skin, (ways = new Map<number, Skin>()));
  let found = ways.get(way);
  if (!found) ways.set(way, (found = derive()));
  return found;
}

const derivedSkins = new WeakMap<Skin, Map<number, Skin>>();
