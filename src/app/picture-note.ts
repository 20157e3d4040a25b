import type { PoseJson } from '../formats/pose-json.ts';

/** What a saved PNG remembers: enough to show the same again. */
export interface PictureNote {
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

/** The note, or nothing where the text is none. */
export function parsePictureNote(text: string): PictureNote | undefined {
  try {
    const json = JSON.parse(text) as Partial<PictureNote> | null;
    if (typeof json?.name !== 'string' || typeof json.pose !== 'object') return undefined;
    const { name, pose, bundled } = json;
    return typeof bundled === 'string' ? { name, pose, bundled } : { name, pose };
  } catch {
    return undefined;
  }
}
