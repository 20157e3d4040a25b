import type { PoseJson } from '../formats/pose-json.ts';

/** The text that a saved PNG carries: enough to show the same character and pose again. */
interface PictureNote {
  /** The id of a bundled character, if it is one. */
  readonly bundled?: string;
  /**
   * The name of the character. The user's own files are never stored in pictures, because pictures
   * get shared.
   */
  readonly name: string;
  readonly pose: PoseJson;
}

export const pictureKeyword = 'Sinew';

export function writePictureNote(note: PictureNote): string {
  return JSON.stringify(note);
}
