import type { CharacterImage } from '../core/character.ts';
import type { Diagnostic } from '../core/diagnostics.ts';
import { setImage } from '../document/look-edits.ts';
import { pictureExtensions } from '../formats/extensions.ts';
import { baseName, extensionOf } from '../formats/file-entry.ts';
import type { FileEntry } from '../formats/format.ts';
import { decodedImages } from '../view/dress/decode-image.ts';
import { imageProblem } from '../view/image-problem.ts';
import type { FileOpener } from './open-files.ts';
import { readBytes } from './read-bytes.ts';

/** Whether files are images and nothing else. */
export function areImages(files: readonly FileEntry[]): boolean {
  return files.every(({ path }) => pictureExtensions.includes(extensionOf(path)));
}

/**
 * Covers the selected character with the first of several images. The others are reported, as is one
 * that can't be decoded or has no character to go to.
 *
 * @returns the name of the image, if it covers the character
 */
export async function coverWithImage(
  { store, selected }: FileOpener,
  files: readonly FileEntry[],
  signal: AbortSignal,
  problems: Diagnostic[],
): Promise<string | undefined> {
  const [first, ...others] = selected ? files : [undefined, ...files];
  for (const file of others) if (file) problems.push(unusedImage(file));
  const image = first && (await readImage(first, problems));
  if (!image || !selected || signal.aborted) return undefined;
  store.dispatch(setImage(selected.id, image));
  return image.name;
}

async function readImage(
  file: FileEntry,
  problems: Diagnostic[],
): Promise<CharacterImage | undefined> {
  const bytes = await readBytes(file, problems);
  if (!bytes) return undefined;
  const image = { name: baseName(file.path), textures: [], bytes };
  const picture = await decodedImages.load(image);
  if (typeof picture !== 'string') return image;
  problems.push(imageProblem(file.path, picture));
  return undefined;
}

function unusedImage({ path }: FileEntry): Diagnostic {
  return {
    severity: 'warning',
    code: 'file/unknown',
    file: path,
    expected: 'a PNG that Sinew saved, or one image for a character that is open',
    found: 'another image',
    effect: 'the file is not used',
  };
}
