import { type Diagnostic, DiagnosticLog } from '../../core/diagnostics.ts';
import { loadPart } from '../../core/failure.ts';
import { sceneExtension } from '../../formats/extensions.ts';
import { baseName, extensionOf } from '../../formats/file-entry.ts';
import type { FileEntry } from '../../formats/format.ts';
import { decodeText } from '../../formats/text/decode-text.ts';
import { pictureKeyword } from '../picture-note.ts';
import { readBytes } from '../read-bytes.ts';

/** The text of a scene, and files that came with it. */
export interface GivenScene {
  /** What the text is called in messages. */
  readonly file: string;
  readonly text: string;
  readonly files: readonly FileEntry[];
  /** Whether it is a scene file, which holds its files. */
  readonly isFile: boolean;
}

/** The name of the text in a scene file. */
export const sceneTextName = 'scene.json';

/** Returns the last scene among files: a scene file, a picture of a scene, or a scene's own text. */
export async function sceneAmong(
  files: readonly FileEntry[],
  problems: Diagnostic[],
): Promise<GivenScene | undefined> {
  const mayBeScenes = files.filter(({ path }) => extensionOf(path) === sceneExtension);
  // A picture beside the files of a character is a texture, and a text beside them is a pose.
  const areTexts = files.every(({ path }) => ['.png', '.json'].includes(extensionOf(path)));
  for (const file of areTexts ? files.toReversed() : mayBeScenes.toReversed()) {
    const extension = extensionOf(file.path);
    const bytes = await readBytes(file, problems);
    if (!bytes) continue;
    const others = files.filter((each) => each !== file);
    const scene =
      extension === sceneExtension
        ? await ofArchive(file.path, bytes, problems)
        : await ofText(file.path, extension, bytes);
    if (scene) return { ...scene, files: [...scene.files, ...others] };
  }
  return undefined;
}

/** Unpacks a scene file, within the limits of every archive. */
async function ofArchive(
  path: string,
  bytes: Uint8Array,
  problems: Diagnostic[],
): Promise<GivenScene | undefined> {
  const { unpackArchive } = await loadPart(import('../../formats/zip/expand-archives.ts'));
  const name = baseName(path);
  const log = new DiagnosticLog(name);
  const files = unpackArchive(bytes, log, () => true);
  const text = files.find((file) => file.path === sceneTextName);
  if (!text && !log.failed) {
    log.error({
      code: 'scene/missing',
      expected: sceneTextName,
      found: `${files.length} other files`,
      effect: 'the scene is not opened',
    });
  }
  problems.push(...log.diagnostics);
  if (!text) return undefined;
  const others = files.filter((file) => file !== text);
  return { file: name, text: decodeText(await text.bytes()), files: others, isFile: true };
}

async function ofText(
  path: string,
  extension: string,
  bytes: Uint8Array,
): Promise<GivenScene | undefined> {
  const { readPngText } = await loadPart(import('../../formats/png/text-chunk.ts'));
  const text = extension === '.png' ? readPngText(bytes, pictureKeyword) : decodeText(bytes);
  return text !== undefined && isScene(text)
    ? { file: baseName(path), text, files: [], isFile: false }
    : undefined;
}

/** Whether a text is a scene, and not the pose that pictures and other files have. */
function isScene(text: string): boolean {
  if (!text.includes('"actors"')) return false; // most texts, and parsing long ones takes a while
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null && 'actors' in value;
  } catch {
    return false;
  }
}
