import type { Character } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import type { ClipParts } from '../core/motion/clip-parts.ts';
import { sameValue } from '../core/same-value.ts';
import { type Influence, influencesOf, type Skin } from '../core/skin.ts';
import { changedSkin } from '../document/skin-edits.ts';
import { type Actor, boundClip, type KeptState } from '../document/scene.ts';
import { nameKey } from '../formats/belonging/paths.ts';
import { companionExtensions, textureExtensions } from '../formats/extensions.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import type { ReadCharacter } from '../formats/read-characters.ts';

/** An open character with the files that it came from. */
export interface OpenedFiles {
  readonly character: Character;
  readonly files: readonly FileEntry[];
}

/**
 * Returns the new files. If all of them are missing or own files of the open character, its other
 * files are added.
 */
export function completeFiles(
  came: readonly FileEntry[],
  open: OpenedFiles | undefined,
): readonly FileEntry[] {
  if (!open || came.length === 0) return came;
  const [oldNames, newNames] = [open.files.map(nameOf), came.map(nameOf)];
  const missing = open.character.missing.map(nameKey);
  const belong = came.every(
    (file) =>
      [...missing, ...companionExtensions].includes(extensionOf(file.path)) ||
      [...missing, ...oldNames].includes(nameOf(file)),
  );
  if (!belong) return came;
  return [...open.files.filter((file) => !newNames.includes(nameOf(file))), ...came];
}

/** Whether all files only add something to a character that is open: images, clips, morphs. */
export function areCompanions(files: readonly FileEntry[]): boolean {
  const extensions = [...companionExtensions, ...textureExtensions];
  return files.every(({ path }) => extensions.includes(extensionOf(path)));
}

/** Whether the files of a character include those of the open one, with the same joints. */
export function renews(
  { character, files }: ReadCharacter,
  open: OpenedFiles | undefined,
): boolean {
  if (!open) return false;
  const came = new Set(files.map(nameOf));
  const [{ names }, { names: oldNames }] = [character.skeleton, open.character.skeleton];
  const sameJoints =
    names.length === oldNames.length && names.every((name, joint) => name === oldNames[joint]);
  return sameJoints && open.files.every((file) => came.has(nameOf(file)));
}

/**
 * The state that an actor passes on to its successor when its files are read again. Clips that the
 * user changed or made stay as they are; the others are the files' new ones.
 */
export function keptState(before: Actor, character: Character): KeptState {
  const { q, name, morphWeights, normalizeWeights, influences, transform, fitted, look } = before;
  const { methodSettings } = before;
  const { morphs } = before.character;
  const weights = new Map(morphs.map(({ name }, index) => [name, morphWeights[index]!]));
  const clips = keptClips(before, character);
  const bound = clips.findIndex(({ name }) => name === boundClip(before)?.name);
  // Morphs may have other places in the files now; joints and values of the same joints have not.
  const hasSameSlots =
    q.length === character.skeleton.qRest.length &&
    before.character.morphs.length === character.morphs.length &&
    before.character.morphs.every(({ name }, at) => name === character.morphs[at]!.name);
  return {
    q,
    name,
    transform,
    fitted,
    morphWeights: Float64Array.from(character.morphs, ({ name }) => weights.get(name) ?? 0),
    clips,
    clip: bound === -1 ? null : bound,
    ...(bound !== -1 && hasSameSlots && { unkeyed: before.unkeyed }),
    methodSettings,
    normalizeWeights,
    influences,
    skin: before.skin && keptSkin(before.skin, before.character, character),
    look,
  };
}

/**
 * The new weights with the rows that the user changed, or null where these can't be told or the files
 * have the same rows now.
 */
function keptSkin(edited: Skin, before: Character, { mesh, skin }: Character): Skin | null {
  if (!fitSkin(before, { mesh, skin })) return null;
  const rows = new Map<number, readonly Influence[]>();
  for (let point = 0; point < mesh.pointCount; point++) {
    const row = influencesOf(edited, point);
    if (!sameValue(row, influencesOf(before.skin, point))) rows.set(point, row);
  }
  return changedSkin({ skin }, skin, rows);
}

/** Whether points and palette entries mean the same in both. */
function fitSkin(
  before: Pick<Character, 'mesh' | 'skin'>,
  { mesh, skin }: Pick<Character, 'mesh' | 'skin'>,
): boolean {
  return (
    before.mesh.pointCount === mesh.pointCount &&
    sameValue(before.skin.paletteJoint, skin.paletteJoint)
  );
}

/** What became of weights that the user changed, for the status line; empty if there were none. */
export function weightsText({ skin, character: before }: Actor, character: Character): string {
  if (!skin) return '';
  return fitSkin(before, character)
    ? ', changed weights too'
    : '; changed weights are dropped, as the vertices are others';
}

function keptClips({ clips, character: old }: Actor, { clips: read }: Character): Actor['clips'] {
  const isOfFile = (clip: ClipParts): boolean => old.clips.includes(clip);
  if (clips.length === old.clips.length && clips.every(isOfFile)) return read;
  const kept = clips.flatMap((clip) =>
    isOfFile(clip) ? (read.find(({ name }) => name === clip.name) ?? []) : clip,
  );
  const known = [...old.clips, ...kept].map(({ name }) => name);
  return [...kept, ...read.filter(({ name }) => !known.includes(name))];
}

/** Reports the missing files of a character, and how to add them. */
export function missingParts({ name, missing }: Character): Diagnostic[] {
  return missing.map((what) => ({
    severity: 'warning',
    code: 'file/missing',
    file: name,
    expected: what.startsWith('.') ? `${name}${what}` : what,
    found: 'no such file',
    effect: 'the rest is shown; drop the file here to complete the character',
  }));
}

function nameOf({ path }: FileEntry): string {
  return nameKey(baseName(path));
}
