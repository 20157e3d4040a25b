/**
 * The endings of each format's files, lower case with the dot. Apart from the readers, so that the
 * page can offer and sort files before it has loaded any reader.
 */
export const formatExtensions = {
  mit: ['.skel', '.obj', '.attach'],
} as const;

/** Endings that are worth reading. */
export const readableExtensions: readonly string[] = [
  ...Object.values(formatExtensions).flat(),
  '.zip',
];
