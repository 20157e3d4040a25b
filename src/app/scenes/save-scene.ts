import { Failure } from '../../core/failure.ts';
import { plainName, withPlainPaths } from '../../formats/belonging/plain-path.ts';
import { sceneExtension } from '../../formats/extensions.ts';
import { pathStem } from '../../formats/file-entry.ts';
import type { OutputFile } from '../../formats/format.ts';
import { download } from '../../ui/download.ts';
import { sceneTextName } from './scene-among.ts';
import type { SceneParts } from './scene-parts.ts';
import { filesOfScene, sceneText } from './scene-text.ts';
import { zipFiles } from './zip-files.ts';

const mediaType = 'application/zip';

/**
 * Saves the scene with the files that it needs: in the file that it was saved in before, in one that
 * the user chooses, or as a download where the browser lets no page write files.
 *
 * @param asNew asks for a file even if there is one
 */
export async function saveScene(parts: SceneParts, asNew: boolean): Promise<void> {
  const { opening, target } = parts;
  // The browser lets a page ask for a file only shortly after a press, so this comes first.
  const handle = (asNew ? null : target.handle) ?? (await chooseFile(target.name));
  if (handle === 'none') return;
  const packed = await opening.whileWorking('Saving the scene', (signal) =>
    packScene(parts, signal),
  );
  if (!packed) return;
  if (!handle) {
    const name = `${target.name}${sceneExtension}`;
    download(name, packed, mediaType);
    opening.notice.value = `Scene saved as ${plainName(name)}`;
    return;
  }
  await write(handle, packed);
  target.handle = handle;
  target.name = pathStem(handle.name);
  opening.notice.value = `Scene saved as ${handle.name}`;
}

/** Packs the scene as it is now into a scene file. */
async function packScene(parts: SceneParts, signal: AbortSignal): Promise<Blob | undefined> {
  const text = new TextEncoder().encode(`${sceneText(parts)}\n`);
  const files: OutputFile[] = [];
  for (const file of filesOfScene(parts, parts.opening.store.scene.peek())) {
    files.push({ path: `files/${file.path}`, bytes: await file.bytes() });
  }
  const packed = [{ path: sceneTextName, bytes: text }, ...withPlainPaths(files)];
  return zipFiles(packed, signal, parts.meter.report);
}

/** Asks for a file; nothing, where the browser can't ask, and 'none' if the user chose none. */
async function chooseFile(name: string): Promise<FileSystemFileHandle | 'none' | undefined> {
  try {
    return await window.showSaveFilePicker?.({
      suggestedName: plainName(`${name}${sceneExtension}`),
      types: [{ description: 'Sinew scene', accept: { [mediaType]: [sceneExtension] } }],
    });
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return 'none';
    return undefined; // as in a frame of another page; a download is allowed nevertheless
  }
}

/** @throws Failure if the file can't be written; it is then as it was */
async function write(handle: FileSystemFileHandle, content: Blob): Promise<void> {
  try {
    const writable = await handle.createWritable();
    await writable.write(content);
    await writable.close();
  } catch (cause) {
    const text = `${handle.name} could not be written; choose another file by "Save scene as"`;
    throw new Failure(text, { cause });
  }
}
