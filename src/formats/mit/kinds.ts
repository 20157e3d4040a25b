import type { PartKinds } from '../belonging/draft.ts';

/** The extension of the files with an OBJ's materials. */
export const libraryExtension = '.mtl';

/** A character's files; its mesh may have several material libraries. */
export const partKinds: PartKinds = {
  single: ['.skel', '.obj', '.attach'],
  many: [libraryExtension],
};
