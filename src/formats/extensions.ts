/**
 * The endings of each format's files, lower case with the dot. Apart from the readers, so that the
 * page can offer and sort files before it has loaded any reader.
 */
export const formatExtensions = {
  mit: ['.skel', '.obj', '.attach'],
  cse169: ['.skel', '.skin', '.morph', '.anim', '.rig'],
  mmd: ['.pmd'],
} as const;

/** Endings of the images that materials may name. */
export const textureExtensions: readonly string[] = ['.bmp', '.png', '.jpg', '.jpeg', '.tga'];

/** Endings of files that add to a character that is open, whatever else it has. */
export const companionExtensions: readonly string[] = ['.morph', '.anim', '.rig'];

export const archiveExtension = '.zip';

/** Endings of the files that make characters, each once. */
export const characterExtensions: readonly string[] = [
  ...new Set<string>([...Object.values(formatExtensions).flat(), archiveExtension]),
];

/** Endings that are worth reading. */
export const readableExtensions: readonly string[] = [...characterExtensions, ...textureExtensions];
