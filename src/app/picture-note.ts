import type { PoseJson } from '../formats/pose-json.ts';

/** What a saved PNG remembers: enough to show the same again. */
interface PictureNote {
  /** Id of a bundled character, where it is one. */
  readonly bundled?: string;
  /** Name of the character; one's own files are not put into pictures, which go around. */
  readonly name: string;
  readonly pose: PoseJson;
}

export const pictureKeyword = 'Sinew';

export function writePictureNote(note: PictureNote): string {
  return JSON.stringify(note);
}
