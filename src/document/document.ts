import type { Character } from '../core/character.ts';
import { normalizeSkin, type Skin } from '../core/skin.ts';
import type { MethodId } from '../skinning/method.ts';

/**
 * All that is saved and undone, as a value: never changed in place, so that an older document stays
 * what it was and undo restores the exact bits. Characters are shared by reference.
 */
export interface Document {
  readonly characters: readonly CharacterState[];
  readonly selectedId: CharacterId | null;
}

export type CharacterId = number;

/** Where a character came from; undo restores it with the character. */
export type Source = { readonly kind: 'bundled'; readonly id: string } | { readonly kind: 'files' };

export interface CharacterState {
  readonly id: CharacterId;
  readonly character: Character;
  readonly source: Source;
  /** (qCount) the pose; never written in place. */
  readonly q: Float64Array;
  /** (morphCount) how much of each morph there is; never written in place. */
  readonly morphWeights: Float64Array;
  /** The bound clip, an index into the character's; its values are shown over `q`. */
  readonly clip: number | null;
  readonly method: MethodId;
  /** Whether rows of weights are divided by their sum; the file's weights are used as they are. */
  readonly normalizeWeights: boolean;
}

/** What of a character's state may be other than as its files have it. */
export type KeptState = Partial<
  Pick<CharacterState, 'source' | 'q' | 'morphWeights' | 'clip' | 'normalizeWeights'>
>;

/** A character as its files have it but for what is given; its values are copied. */
export function characterState(
  id: CharacterId,
  character: Character,
  method: MethodId,
  kept: KeptState = {},
): CharacterState {
  const { source = { kind: 'files' }, clip = null, normalizeWeights = false } = kept;
  return {
    id,
    character,
    source,
    q: (kept.q ?? character.skeleton.qRest).slice(),
    morphWeights: kept.morphWeights?.slice() ?? new Float64Array(character.morphs.length),
    clip,
    method,
    normalizeWeights,
  };
}

export const emptyDocument: Document = { characters: [], selectedId: null };

export function selectedCharacter(document: Document): CharacterState | undefined {
  return document.characters.find(({ id }) => id === document.selectedId);
}

/** The weights in use: the file's, or those divided by their sums. */
export function skinInUse({ character, normalizeWeights }: CharacterState): Skin {
  if (!normalizeWeights) return character.skin;
  let normalized = normalizedSkins.get(character.skin);
  if (!normalized)
    normalizedSkins.set(character.skin, (normalized = normalizeSkin(character.skin)));
  return normalized;
}

const normalizedSkins = new WeakMap<Skin, Skin>();
