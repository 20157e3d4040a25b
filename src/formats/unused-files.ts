import { type Diagnostic } from '../core/diagnostics.ts';
import { characterExtensions, foreignImageExtensions, textureExtensions } from './extensions.ts';
import { baseName, extensionOf } from './file-entry.ts';
import type { FileEntry } from './format.ts';

/**
 * Reports the files that belong to no character: one warning for each reason, because a folder may
 * hold hundreds.
 */
export function reportUnused(files: readonly FileEntry[]): Diagnostic[] {
  const endsIn = (extensions: readonly string[]) => files.filter(hasOneOf(extensions));
  const images = endsIn(textureExtensions);
  const foreignImages = endsIn(foreignImageExtensions);
  const isImage = hasOneOf([...textureExtensions, ...foreignImageExtensions]);
  const others = files.filter((file) => !isImage(file));
  return [
    ...report(images, {
      expected: 'images that a material names',
      found: images.length > 1 ? 'images that none names' : 'an image that none names',
    }),
    ...report(foreignImages, {
      expected: `images that Sinew reads (${textureExtensions.join(', ')})`,
      found: endingsOf(foreignImages),
    }),
    ...report(others, {
      expected: `files that Sinew reads (${characterExtensions.join(', ')})`,
      found: endingsOf(others),
    }),
  ];
}

function hasOneOf(extensions: readonly string[]): (file: FileEntry) => boolean {
  return ({ path }) => extensions.includes(extensionOf(path));
}

function endingsOf(files: readonly FileEntry[]): string {
  return [...new Set(files.map(({ path }) => extensionOf(path) || 'no ending'))].join(', ');
}

function report(
  files: readonly FileEntry[],
  message: Pick<Diagnostic, 'expected' | 'found'>,
): Diagnostic[] {
  const [first, ...others] = files.map(({ path }) => baseName(path));
  if (first === undefined) return [];
  return [
    {
      severity: 'warning',
      code: 'file/unknown',
      file: others.length > 0 ? `${first} and ${others.length} more` : first,
      ...message,
      effect: others.length > 0 ? 'they are not used' : 'the file is not used',
    },
  ];
}
