/**
 * The extensions of each format's files, lower case with the dot. They are separate from the
 * readers, so that the page can offer and sort files before it has loaded any reader.
 */
export const formatExtensions = {
  mit: ['.skel', '.obj', '.attach', '.mtl'],
  cse169: ['.skel', '.skin', '.morph', '.anim', '.rig'],
  mmd: ['.pmd'],
} as const;

/** Extensions of the images that materials may name. */
export const textureExtensions: readonly string[] = ['.bmp', '.png', '.jpg', '.jpeg', '.tga'];

/** Extensions of images that can cover a character. */
export const pictureExtensions: readonly string[] = [...textureExtensions, '.gif', '.webp'];

/** Extensions of images that are not read, so that a message can say which are. */
export const foreignImageExtensions: readonly string[] = [
  ...['.gif', '.webp', '.avif', '.heic', '.svg', '.tif', '.tiff', '.psd', '.dds', '.ktx2'],
  ...['.exr', '.hdr', '.sph', '.spa'],
];

/** Extensions of files that add something to a character that is already open. */
export const companionExtensions: readonly string[] = ['.morph', '.anim', '.rig'];

export const archiveExtension = '.zip';

/** The extension of scene files, which are archives too. */
export const sceneExtension = '.sinew';

/** Extensions of the files that make characters, without duplicates. */
export const characterExtensions: readonly string[] = [
  ...new Set<string>([...Object.values(formatExtensions).flat(), archiveExtension]),
];

/** Extensions of all files that are read. */
export const readableExtensions: readonly string[] = [...characterExtensions, ...textureExtensions];
